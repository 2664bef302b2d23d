/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/eval/PairBound.h>
#include <psmks/geometry/Observability.h>
#include <tests/support/Scenes.h>

#include <Eigen/Dense>
#include <cmath>

namespace psmks
{
namespace
{
constexpr double kSigma_m = 0.01, kMaxRange_m = 8;
const BeamGrid kGrid = BeamGrid::centered(kPi, 361);
const Pose2 kReference{0, 0, 0.5}, kMotion{0.3, -0.2, 0.15};

// ---------------+  3
//                |
//     o->        |     two walls of a corner, both seen by both scans
//     0          |
//                2
const std::vector<Wall> kCorner{{{-6, 3}, {2, 3}}, {{2, 3}, {2, -6}}};

Scan scanOf(const std::vector<Wall>& walls, const Pose2& T_world_sensor)
{
  return castScan(walls, T_world_sensor, kGrid, kMaxRange_m);
}

PairBound exactBound(const std::vector<Wall>& walls, double sigma_m = kSigma_m)
{
  return pairBound(scanOf(walls, kReference), scanOf(walls, kReference * kMotion), kMotion,
                   {sigma_m});
}

/** The pose between two scans from their maximum likelihood lines, which hold all the information
 * of the rays about it. A line has the angle phi and the distance r, so that
 *
 *     phi_cur - phi_ref = -theta,    r_cur - r_ref = -n(phi_ref).t
 *
 * is linear in the pose. The errors of its two sides are those of four numbers of each wall. */
struct LineRegression
{
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d pose = Eigen::Vector3d::Zero();

  LineRegression(const SegmentedScan& reference, const SegmentedScan& current)
  {
    Eigen::Vector3d pull = Eigen::Vector3d::Zero();
    for (std::size_t s = 0; s < reference.segments.size(); ++s)
    {
      const Line &ref = reference.segments[s].line, &cur = current.segments[s].line;
      const Eigen::Vector2d n = ref.normal(), turned(-n.y(), n.x());
      Eigen::Matrix<double, 2, 3> J;
      J << -n.transpose(), 0, 0, 0, -1;
      Eigen::Matrix2d A;  // derivative by the error of the reference line
      A << -1, turned.dot(kMotion.translation()), 0, -1;
      const Eigen::Matrix2d weight =
          (cur.covariance + A * ref.covariance * A.transpose()).inverse();
      information += J.transpose() * weight * J;
      pull += J.transpose() * weight *
              Eigen::Vector2d(cur.r0_m - ref.r0_m, wrapAngle(cur.phi0_rad - ref.phi0_rad));
    }
    pose = information.ldlt().solve(pull);
  }
};

LineRegression regression(const std::vector<Wall>& walls, const Scan& reference,
                          const Scan& current)
{
  const SegmentedScan ref = segmentByWalls(reference, walls, kReference);
  const SegmentedScan cur = segmentByWalls(current, walls, kReference * kMotion);
  return {ref, cur};
}
}  // namespace

TEST(PairBound, OfACornerIsThatOfItsTwoLines)
{
  const LineRegression expected =
      regression(kCorner, scanOf(kCorner, kReference), scanOf(kCorner, kReference * kMotion));
  const Eigen::Matrix3d actual = exactBound(kCorner).information;
  EXPECT_TRUE(actual.isApprox(expected.information, 0.01)) << actual << "\nis not nearly\n"
                                                           << expected.information;
}

TEST(PairBound, OneWallSaysNothingAlongItself)
{
  const std::vector<Wall> wall{{{-30, 2}, {30, 2}}};
  const Observability known = observability(exactBound(wall).information);
  EXPECT_GT(known.weakSigma_m, 10);
  const Eigen::Vector2d alongWall = kReference.rotation().transpose() * Eigen::Vector2d::UnitX();
  EXPECT_GT(std::abs(known.weakDirection.dot(alongWall)), 0.999);
  EXPECT_TRUE(std::isnan(summarize({exactBound(wall)}).translationMedian_m));
  EXPECT_LT(summarize({exactBound(wall)}).rotationMedian_rad, degToRad(0.1));
}

TEST(PairBound, ScansWithoutAnythingInCommonSayNothing)
{
  const Scan nothing = scanOf({}, kReference);
  EXPECT_EQ(pairBound(nothing, scanOf(kCorner, kReference), {}, {kSigma_m}).information.norm(), 0);
  EXPECT_EQ(pairBound(nothing, nothing, {}, {kSigma_m}).information.norm(), 0);
}

TEST(PairBound, InformationFallsWithTheSquareOfTheNoise)
{
  const Eigen::Matrix3d once = exactBound(kCorner).information;
  const Eigen::Matrix3d twice = exactBound(kCorner, 2 * kSigma_m).information;
  EXPECT_TRUE((4 * twice).isApprox(once, 0.01)) << 4 * twice << "\nis not nearly\n" << once;
}

// A box that only the current scan sees hides a part of the wall and adds two sides of its own.
TEST(PairBound, AWallThatOnlyOneScanSeesDoesNotCount)
{
  const std::vector<Wall> withBox = []
  {
    std::vector<Wall> walls = kCorner;
    for (const Wall& side : box({1.0, 1.5}, 0.4, 0.4)) walls.push_back(side);
    return walls;
  }();
  const Scan corner = scanOf(kCorner, kReference);
  const Scan boxed = scanOf(withBox, kReference * kMotion);
  const Eigen::Matrix3d actual = pairBound(corner, boxed, kMotion, {kSigma_m}).information;
  EXPECT_LT(actual.trace(), exactBound(kCorner).information.trace());
  EXPECT_GT(actual.trace(), 0.3 * exactBound(kCorner).information.trace());
}

TEST(PairBound, IsTheScatterOfTheMaximumLikelihoodEstimate)
{
  constexpr unsigned kSeed = 11;
  constexpr int kDraws = 600;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  std::mt19937 random(kSeed);
  const auto noisy = [&random](const Pose2& pose)
  { return castScan(kCorner, pose, kGrid, kMaxRange_m, kSigma_m, random); };
  const Eigen::Vector3d truth(kMotion.x_m, kMotion.y_m, kMotion.phi_rad);
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  std::vector<PairBound> bounds;
  for (int draw = 0; draw < kDraws; ++draw)
  {
    const Scan reference = noisy(kReference), current = noisy(kReference * kMotion);
    const Eigen::Vector3d error = regression(kCorner, reference, current).pose - truth;
    spread += error * error.transpose() / kDraws;
    if (draw < 20) bounds.push_back(pairBound(reference, current, kMotion, {kSigma_m}));
  }
  // The covariance of the draws times the information is the identity, except for the sampling
  // error of 1 / sqrt(draws / 2) = 6 %.
  for (const PairBound& bound : bounds)
  {
    const Eigen::Matrix3d root = bound.information.llt().matrixU();
    EXPECT_TRUE((root * spread * root.transpose()).isIdentity(0.2))
        << root * spread * root.transpose();
  }
}

TEST(BoundSummary, HasTheQuantilesOfTheErrors)
{
  // 3 mm in x and y: a Rayleigh distribution, median 1.1774, p95 2.4477 sigma;
  // 0.1 deg: half a normal one, median 0.6745, p95 1.96 sigma.
  PairBound bound;
  bound.information.diagonal() << 1 / 9e-6, 1 / 9e-6, std::pow(degToRad(0.1), -2);
  const BoundSummary summary = summarize(std::vector<PairBound>(500, bound));
  EXPECT_NEAR(summary.translationMedian_m, 1.1774 * 3e-3, 0.1e-3);
  EXPECT_NEAR(summary.translationP95_m, 2.4477 * 3e-3, 0.2e-3);
  EXPECT_NEAR(radToDeg(summary.rotationMedian_rad), 0.06745, 0.003);
  EXPECT_NEAR(radToDeg(summary.rotationP95_rad), 0.196, 0.008);
  EXPECT_TRUE(std::isnan(summarize(std::vector<PairBound>()).translationMedian_m));
}

TEST(BoundSummary, HeadingMayDependOnThePosition)
{
  // With this coupling, the variance of each is four times what it is if the other one is known.
  PairBound bound;
  bound.information << 4, 0, -std::sqrt(12.0), 0, 4, 0, -std::sqrt(12.0), 0, 4;
  bound.information *= 1e6;
  const BoundSummary summary = summarize(std::vector<PairBound>(500, bound));
  EXPECT_NEAR(summary.rotationMedian_rad, 0.6745 * 1e-3, 0.05e-3);
}
}  // namespace psmks
