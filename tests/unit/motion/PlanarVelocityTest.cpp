/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/motion/PlanarVelocity.h>

#include <limits>
#include <utility>

namespace psmks
{
namespace
{
void expectVelocity(const PlanarVelocity& velocity, const PlanarVelocity& expected,
                    double tolerance = 1e-9)
{
  EXPECT_NEAR(velocity.x_m_s, expected.x_m_s, tolerance);
  EXPECT_NEAR(velocity.y_m_s, expected.y_m_s, tolerance);
  EXPECT_NEAR(velocity.phi_rad_s, expected.phi_rad_s, tolerance);
}

UncertainPose turn(double phi_rad) { return {{0, 0, phi_rad}, Eigen::Matrix3d::Zero()}; }

TEST(MeanVelocity, IsThatOfTheLastFifthOfASecond)
{
  MeanVelocity mean;
  EXPECT_TRUE(mean.velocity().isZero());
  for (int i = 0; i <= 10; ++i)
    mean.add(0.1 * i, {i < 6 ? Pose2() : Pose2{0.02, 0.01, 0}, Eigen::Matrix3d::Zero()});
  expectVelocity(mean.velocity(), {0.2, 0.1, 0});
}

//      ^ heading after a quarter of a circle of 1 m radius: the robot drives ahead
//      |   all the time, whatever the chord from start to end points to
//      o
//     /
//  o-'
TEST(MeanVelocity, OnAnArcIsStraightAhead)
{
  MeanVelocity mean;
  constexpr double kRate_rad_s = 0.5;
  const double chord_m = 2 * std::sin(kRate_rad_s / 2);  // of a second
  const Pose2 motion{chord_m * std::cos(kRate_rad_s / 2), chord_m * std::sin(kRate_rad_s / 2),
                     kRate_rad_s};
  for (int i = 0; i <= 2; ++i) mean.add(i, {motion, Eigen::Matrix3d::Zero()});
  expectVelocity(mean.velocity(), {chord_m, 0, kRate_rad_s});
}

// Messages that waited together come with stamps milliseconds apart.
TEST(MeanVelocity, StampsThatJitterDoNotMakeASpin)
{
  MeanVelocity mean;
  for (int i = 0; i <= 20; ++i) mean.add(0.1 * i + (i % 2 ? 0.045 : 0), turn(0.02));
  EXPECT_NEAR(mean.velocity().phi_rad_s, 0.2, 0.05);
}

TEST(MeanVelocity, RecoversFromWhatIsNotFinite)
{
  using Reading = std::pair<double, double>;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const auto& [stamp_s, turned_rad] : {Reading(nan, 0.02), Reading(0.5, nan)})
  {
    MeanVelocity mean;
    mean.add(0, turn(0));
    mean.add(0.4, turn(0.02));
    mean.add(stamp_s, turn(turned_rad));
    EXPECT_TRUE(mean.velocity().isZero());
    for (int i = 5; i <= 10; ++i) mean.add(0.1 * i, turn(0.02));
    expectVelocity(mean.velocity(), {0, 0, 0.2});
  }
}

TEST(MeanVelocity, IsZeroWhereStampsTellNothing)
{
  MeanVelocity same, back, gap;
  for (int i = 0; i < 5; ++i) same.add(7, turn(0.1));
  back.add(7, turn(0));
  back.add(6, turn(0.1));
  gap.add(7, turn(0));
  gap.add(17, turn(0.1));
  for (const MeanVelocity& mean : {same, back, gap})
  {
    EXPECT_TRUE(mean.velocity().isZero());
    EXPECT_TRUE(mean.covariance().isZero());
  }
}

// 3 cm in each of two motions of half a second, of which the last one counts: 6 cm/s.
TEST(MeanVelocity, IsAsUncertainAsTheMotions)
{
  MeanVelocity mean;
  const Eigen::Matrix3d covariance = Eigen::Vector3d(9e-4, 9e-4, 1e-4).asDiagonal();
  for (int i = 0; i <= 2; ++i) mean.add(0.5 * i, {{0.2, 0, 0}, covariance});
  EXPECT_NEAR(std::sqrt(mean.covariance()(0, 0)), 0.06, 1e-9);
  EXPECT_NEAR(std::sqrt(mean.covariance()(2, 2)), 0.02, 1e-9);
}

//      left            a scanner half a metre ahead that looks to the left: where the robot
//       ^ scanner      turns with 2 rad/s the scanner swings to the left with 1 m/s, which is
//   o===|              ahead for it
TEST(PlanarVelocity, ATurningRobotSwingsItsScanner)
{
  const PlanarVelocity ofSensor = velocityOfSensor({0.3, 0, 2}, {0.5, 0, kPi / 2});
  expectVelocity(ofSensor, {1, -0.3, 2});
}
}  // namespace
}  // namespace psmks
