/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/geometry/Line.h>
#include <tests/support/RandomNumbers.h>

#include <Eigen/Cholesky>

namespace psmks
{
namespace
{
Eigen::Matrix2d someCovariance()
{
  return (Eigen::Matrix2d() << 4e-4, 1e-4, 1e-4, 9e-4).finished();
}

Line randomLine(test::RandomNumbers& random)
{
  return {random.uniform(0.1, 5), random.uniform(-kPi, kPi), someCovariance()};
}

Pose2 randomPose(test::RandomNumbers& random)
{
  return {random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-kPi, kPi)};
}

/** The point of a line that lies `along_m` from the foot, on the counter-clockwise side. */
Eigen::Vector2d pointOn(const Line& line, double along_m)
{
  const Eigen::Vector2d n = line.normal();
  return line.r0_m * n + along_m * Eigen::Vector2d(-n.y(), n.x());
}

/** d(r0', phi0') / d(r0, phi0) of a change of frame, by central differences. */
Eigen::Matrix2d numericJacobian(const Line& line, const Pose2& T_to_from)
{
  const double step = 1e-6;
  Eigen::Matrix2d J;
  for (int column = 0; column < 2; ++column)
  {
    Line above = line, below = line;
    (column == 0 ? above.r0_m : above.phi0_rad) += step;
    (column == 0 ? below.r0_m : below.phi0_rad) -= step;
    const Line a = above.transformed(T_to_from), b = below.transformed(T_to_from);
    J.col(column) << a.r0_m - b.r0_m, wrapAngle(a.phi0_rad - b.phi0_rad);
  }
  return J / (2 * step);
}
}  // namespace

//        |   /        wall x = 2, sensor in the origin:
//   o----+--/--       the ray at 45 degrees meets it at 2 sqrt(2)
//     2  | /
TEST(Line, ARayMeetsTheLineAtItsRange)
{
  const Line wall{2, 0};
  EXPECT_DOUBLE_EQ(wall.rangeAt_m(0), 2);
  EXPECT_DOUBLE_EQ(wall.rangeAt_m(degToRad(45)), 2 * std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(wall.rangeAt_m(degToRad(-60)), 4);
}

TEST(Line, ARayAlongTheLineOrAwayFromItMeetsItNowhere)
{
  const Line wall{2, 0};
  EXPECT_EQ(wall.rangeAt_m(degToRad(91)), INFINITY);
  EXPECT_EQ(wall.rangeAt_m(kPi), INFINITY);
}

TEST(Line, DistanceIsPositiveBeyondTheLine)
{
  const Line wall{2, 0};
  EXPECT_DOUBLE_EQ(wall.distance_m({3, 7}), 1);
  EXPECT_DOUBLE_EQ(wall.distance_m({0.5, -7}), -1.5);
}

TEST(Line, ItsPointsLieOnItInEveryFrame)
{
  test::RandomNumbers random(31);
  SCOPED_TRACE(random.seedText());
  for (int n = 0; n < 200; ++n)
  {
    const Line line = randomLine(random);
    const Pose2 T_to_from = randomPose(random);
    const Line moved = line.transformed(T_to_from);
    EXPECT_GE(moved.r0_m, 0);
    EXPECT_GT(moved.phi0_rad, -kPi);
    EXPECT_LE(moved.phi0_rad, kPi);
    for (const double along_m : {-2.0, 3.0})
      EXPECT_NEAR(moved.distance_m(T_to_from * pointOn(line, along_m)), 0, 1e-12);
  }
}

TEST(Line, ThereAndBackIsTheSameLineWithTheSameCovariance)
{
  test::RandomNumbers random(32);
  SCOPED_TRACE(random.seedText());
  for (int n = 0; n < 200; ++n)
  {
    const Line line = randomLine(random);
    const Pose2 T_to_from = randomPose(random);
    const Line back = line.transformed(T_to_from).transformed(T_to_from.inverse());
    EXPECT_NEAR(back.r0_m, line.r0_m, 1e-12);
    EXPECT_NEAR(wrapAngle(back.phi0_rad - line.phi0_rad), 0, 1e-12);
    EXPECT_TRUE(back.covariance.isApprox(line.covariance, 1e-9)) << back.covariance;
  }
}

TEST(Line, TheCovarianceIsPropagatedByTheNumericJacobian)
{
  test::RandomNumbers random(33);
  SCOPED_TRACE(random.seedText());
  for (int n = 0; n < 200; ++n)
  {
    const Line line = randomLine(random);
    const Pose2 T_to_from = randomPose(random);
    const Line moved = line.transformed(T_to_from);
    if (moved.r0_m < 1e-3) continue;  // the fold at the origin has no derivative
    const Eigen::Matrix2d J = numericJacobian(line, T_to_from);
    EXPECT_TRUE(moved.covariance.isApprox(J * line.covariance * J.transpose(), 1e-6))
        << moved.covariance;
  }
}

//            |
//   from o---+---o to      the line x = 2, seen from (5, 0): 3 m behind that frame's back
//            |
TEST(Line, SeenFromTheOtherSideItSaysSo)
{
  const Line wall{2, 0, someCovariance()};
  const Pose2 T_from_to{5, 0, 0};
  bool flipped = false;
  const Line behind = wall.transformed(T_from_to.inverse(), &flipped);
  EXPECT_TRUE(flipped);
  EXPECT_DOUBLE_EQ(behind.r0_m, 3);
  EXPECT_DOUBLE_EQ(behind.phi0_rad, kPi);

  const Line near = wall.transformed(Pose2{1, 0, 0}.inverse(), &flipped);
  EXPECT_FALSE(flipped);
  EXPECT_DOUBLE_EQ(near.r0_m, 1);
}

TEST(Line, FoldingANegativeRadiusTurnsTheSignOfTheCorrelation)
{
  const Line folded = Line::fromNormalForm(-2, degToRad(30), someCovariance());
  EXPECT_DOUBLE_EQ(folded.r0_m, 2);
  EXPECT_NEAR(folded.phi0_rad, degToRad(-150), 1e-15);
  EXPECT_DOUBLE_EQ(folded.covariance(0, 1), -someCovariance()(0, 1));
  EXPECT_DOUBLE_EQ(folded.covariance(1, 0), -someCovariance()(1, 0));
  EXPECT_DOUBLE_EQ(folded.covariance(0, 0), someCovariance()(0, 0));
  EXPECT_DOUBLE_EQ(folded.covariance(1, 1), someCovariance()(1, 1));
}

TEST(Line, TheVarianceOfADistanceIsThatOfManyDrawnLines)
{
  test::RandomNumbers random(34);
  SCOPED_TRACE(random.seedText());
  const Line line{2, degToRad(40), someCovariance()};
  const Eigen::Vector2d p = pointOn(line, 1.5);
  const Eigen::Matrix2d root = line.covariance.llt().matrixL();

  const int draws = 20000;
  double sumOfSquares_m2 = 0;
  for (int n = 0; n < draws; ++n)
  {
    const Eigen::Vector2d error = root * Eigen::Vector2d(random.normal(1), random.normal(1));
    const Line drawn{line.r0_m + error.x(), line.phi0_rad + error.y()};
    sumOfSquares_m2 += drawn.distance_m(p) * drawn.distance_m(p);
  }
  EXPECT_NEAR(sumOfSquares_m2 / draws, line.distanceVariance_m2(1.5),
              0.05 * line.distanceVariance_m2(1.5));
}
}  // namespace psmks
