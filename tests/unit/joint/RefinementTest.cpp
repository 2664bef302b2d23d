/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/core/Matcher.h>
#include <tests/support/Scenes.h>

namespace psmks
{
namespace
{
//   +--------------+       a hall of 20 x 12 m with a recess
//   |   r c        |
//   |         +----+
//   +---------+
std::vector<Wall> hall() { return outline({{-6, -6}, {6, -6}, {6, 0}, {14, 0}, {14, 6}, {-6, 6}}); }

const Pose2 kT_ref_cur{0.3, 0.1, degToRad(3)};

MatchResult match(double sigma_m, unsigned seed)
{
  std::mt19937 rng(seed);
  const BeamGrid grid = BeamGrid::centered(kPi, 361);
  const Scan reference = castScan(hall(), {}, grid, 30, sigma_m, rng);
  const Scan current = castScan(hall(), kT_ref_cur, grid, 30, sigma_m, rng);
  const Eigen::Vector3d sigmas(0.05, 0.05, degToRad(2));
  MatcherWorkspace workspace;
  const Eigen::Matrix3d covariance = sigmas.cwiseAbs2().asDiagonal();
  return Matcher().match(reference, current, {kT_ref_cur, covariance}, workspace);
}
}  // namespace

/** Walls seen with 30 cm of noise are known to 5 cm or so, the width of the last gates. */
TEST(Refinement, KeepsTheWallsOfANoisyScan)
{
  constexpr int kMatches = 40;
  int raysPaired = 0;
  for (unsigned seed = 1; seed <= kMatches; ++seed)
  {
    const MatchResult result = match(0.3, seed);
    EXPECT_TRUE(result.usable()) << "seed " << seed << ": " << result.report();
    raysPaired += result.associations;
  }
  EXPECT_GT(raysPaired / kMatches, 270) << "of 361";
}
}  // namespace psmks
