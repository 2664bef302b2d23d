/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/core/Matcher.h>
#include <tests/support/PoseMatcher.h>

#include <cmath>
#include <random>

namespace psmks
{
namespace
{
//       . - ~ - .
//     .     o>    .      A scanner in a round room sees the same at every heading.
//    (             )     Its position in the circle is all there is to know.
//     .           .
//       ` - . - '

Scan roundRoom(double radius_m, const Pose2& T_centre_sensor, const BeamGrid& grid, unsigned seed)
{
  std::mt19937 generator(seed);
  std::normal_distribution<double> noise_m(0, 0.01);
  const Eigen::Vector2d p = T_centre_sensor.translation();
  Scan scan;
  scan.grid = grid;
  scan.maxRange_m = 80;
  for (int i = 0; i < grid.count(); ++i)
  {
    const double toCentre_m = -p.dot(T_centre_sensor.rotation() * grid.direction(i));
    const double chord_m =
        std::sqrt(toCentre_m * toCentre_m + radius_m * radius_m - p.squaredNorm());
    scan.range_m.push_back(toCentre_m + chord_m + noise_m(generator));
  }
  return scan;
}

class RoundRoom : public ::testing::TestWithParam<double>
{
};

TEST_P(RoundRoom, LeavesTheHeadingOpenAndFindsThePosition)
{
  const double radius_m = GetParam();
  const Matcher matcher;
  MatcherWorkspace workspace;
  for (const double fieldOfView_rad : {kPi, 2 * kPi})
  {
    const BeamGrid grid = BeamGrid::centered(fieldOfView_rad, 360);
    const Pose2 first, second{0.10, 0.05, degToRad(10)};
    const Guess guess{{0, 0, second.phi_rad}, {}};
    const MatchResult result =
        matcher.match(roundRoom(radius_m, first, grid, 1), roundRoom(radius_m, second, grid, 2),
                      guess, workspace);
    EXPECT_EQ(result.status, MatchStatus::Degenerate) << result.report();
    EXPECT_TRUE(result.headingUnobservable) << result.report();
    EXPECT_TRUE(isNearly(result.T_ref_cur, second, 0.02, 1e-9)) << result.report();
    EXPECT_GT(std::sqrt(result.covariance(2, 2)), degToRad(20)) << result.report();
  }
}

INSTANTIATE_TEST_SUITE_P(Radii, RoundRoom, ::testing::Values(2.0, 5.0, 15.0));
}  // namespace
}  // namespace psmks
