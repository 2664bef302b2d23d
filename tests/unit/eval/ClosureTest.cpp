/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/eval/Closure.h>
#include <tests/support/Scenes.h>

#include <Eigen/LU>
#include <cmath>
#include <random>

namespace psmks
{
namespace
{
constexpr int kDraws = 30;

/** Closures with errors of known standard deviations, whose covariances are those of as many draws
 * of the noise alone. */
std::vector<Closure> closuresWith(double noise_m, double missing_m)
{
  std::mt19937_64 random(3);
  std::normal_distribution<double> unit;
  const auto drawn = [&](double sigma) -> Eigen::Vector3d
  { return sigma * Eigen::Vector3d(unit(random), unit(random), unit(random)); };
  std::vector<Closure> closures(2000);
  for (Closure& closure : closures)
  {
    std::vector<Eigen::Vector3d> draws;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (int i = 0; i < kDraws; ++i)
    {
      draws.push_back(drawn(noise_m));
      mean += draws.back() / kDraws;
    }
    closure.covariance.setZero();
    for (const Eigen::Vector3d& draw : draws)
      closure.covariance += (draw - mean) * (draw - mean).transpose() / (kDraws - 1);
    closure.error = drawn(noise_m) + drawn(std::sqrt(3.0) * missing_m);
  }
  return closures;
}
}  // namespace

TEST(Closure, ErrorsOfTheNoiseHaveAMeanSquareOfThree)
{
  const ClosureExperiment experiment({}, kDraws, 1);
  double sum = 0;
  for (const Closure& closure : closuresWith(0.002, 0)) sum += experiment.normalizedSquare(closure);
  EXPECT_NEAR(sum / 2000, 3, 0.3);
}

TEST(Closure, NothingIsMissingWhereTheNoiseExplainsTheErrors)
{
  const MissingSigma missing = missingSigma(closuresWith(0.002, 0), kDraws);
  EXPECT_LT(missing.sigma_m, 0.0004);
  EXPECT_LT(missing.sigma_rad, 0.0004);
}

TEST(Closure, WhatEachMatchErrsBesidesIsFound)
{
  const MissingSigma missing = missingSigma(closuresWith(0.002, 0.003), kDraws);
  EXPECT_NEAR(missing.sigma_m, 0.003, 0.0003);
  EXPECT_NEAR(missing.sigma_rad, 0.003, 0.0003);
}

//   +-----------+
//   |  a  b  c  |    a room, and three exact scans in it
//   +-----------+
TEST(Closure, ExactScansClose)
{
  const BeamGrid grid = BeamGrid::centered(2 * kPi, 360);
  const std::vector<Wall> room = outline({{-3, -2}, {4, -2}, {4, 3}, {-3, 3}});
  const Scan a = castScan(room, {0, 0, 0}, grid), b = castScan(room, {0.2, 0, 0.1}, grid),
             c = castScan(room, {0.4, 0.1, 0.2}, grid);
  ClosureExperiment experiment({}, kDraws, 1);
  const auto closure = experiment.close(a, b, c, {}, {});
  ASSERT_TRUE(closure.has_value());
  EXPECT_LT(closure->error.norm(), 1e-3);
  EXPECT_GT(closure->covariance.determinant(), 0);

  Scan blind = b;
  blind.range_m.assign(360, 0);
  EXPECT_FALSE(experiment.close(a, blind, c, {}, {}).has_value()) << "a match fails";
}
}  // namespace psmks
