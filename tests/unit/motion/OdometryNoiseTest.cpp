/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/motion/OdometryNoise.h>

namespace psmks
{
namespace
{
OdometryOptions plainOptions()
{
  OdometryOptions o;
  o.minSigma_m = 0.01;
  o.minSigma_rad = 0.001;
  o.sigmaPerMetre_m = 0.1;
  o.sigmaPerTurn_m = 0.4;
  o.sigmaPerMetre_rad = 0.02;
  o.sigmaPerTurn_rad = 0.8;
  return o;
}

void expectSigmas(const Eigen::Matrix3d& covariance, double sigma_m, double sigma_rad)
{
  EXPECT_NEAR(std::sqrt(covariance(0, 0)), sigma_m, 1e-12);
  EXPECT_NEAR(std::sqrt(covariance(1, 1)), sigma_m, 1e-12);
  EXPECT_NEAR(std::sqrt(covariance(2, 2)), sigma_rad, 1e-12);
  EXPECT_EQ(covariance(0, 2), 0);
}

TEST(OdometryNoise, StandingStillLeavesTheMinimum)
{
  expectSigmas(odometryCovariance({0, 0, 0}, plainOptions()), 0.01, 0.001);
}

TEST(OdometryNoise, WayAndTurnAddTheirShares)
{
  // 5 m and a quarter of a turn to the right
  expectSigmas(odometryCovariance({3, 4, -kPi / 2}, plainOptions()), 0.01 + 0.5 + 0.1,
               0.001 + 0.1 + 0.2);
}

TEST(OdometryNoise, AMotionThatWasNotMeasuredHasItsOwnUncertainty)
{
  OdometryOptions options = plainOptions();
  options.unknownSigma_m = 0.7;
  options.unknownSigma_rad = 0.3;
  expectSigmas(unknownMotionCovariance(options), 0.7, 0.3);
}

TEST(OdometryNoise, EveryOptionStandsInTheTable)
{
  OdometryOptions options;
  OptionTable table;
  listFields(table, options);
  table.set("odometry", "sigma_per_turn_deg", "90");
  EXPECT_DOUBLE_EQ(options.sigmaPerTurn_rad, kPi / 2);
  EXPECT_EQ(table.fields().size(), 10u);
}
}  // namespace
}  // namespace psmks
