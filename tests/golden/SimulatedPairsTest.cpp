/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/core/Matcher.h>
#include <psmks/sim/Laser.h>
#include <psmks/sim/World.h>
#include <tests/support/PoseMatcher.h>

#include <ostream>

namespace psmks
{
namespace
{
/** A simulated pair of scans. The same seed gives the same noise. */
struct GoldenPair
{
  const char* name;
  World world;
  int fieldOfView_deg, rays;
  double maxRange_m, rangeSigma_m;
  Pose2 T_world_ref, T_ref_cur;
};

void PrintTo(const GoldenPair& pair, std::ostream* out) { *out << pair.name; }

std::vector<GoldenPair> goldenPairs()
{
  const Pose2 T_world_ref{-1.5, 2.3, 0.4};
  return {
      {"RoomSmall", World::smallRoom(), 180, 181, 30, 0.01, T_world_ref, {0.10, 0.05, 0.05}},
      {"RoomLarge", World::smallRoom(), 180, 181, 30, 0.01, T_world_ref, {0.60, -0.30, 0.50}},
      {"RoomShortSighted", World::smallRoom(), 180, 361, 8, 0.01, T_world_ref, {0.20, 0.1, -0.2}},
      {"RoomAllRound", World::smallRoom(), 360, 360, 30, 0.01, T_world_ref, {-0.40, 0.30, 0.80}},
      {"ClutterFine", World::smallClutter(3), 270, 1081, 30, 0.005, T_world_ref, {0.3, 0.2, -0.3}},
      {"ClutterNoisy", World::smallClutter(5), 270, 541, 30, 0.03, T_world_ref, {0.2, -0.2, 0.2}}};
}

class SimulatedPairs : public testing::TestWithParam<GoldenPair>
{
};

INSTANTIATE_TEST_SUITE_P(Golden, SimulatedPairs, testing::ValuesIn(goldenPairs()),
                         [](const auto& pair) -> std::string { return pair.param.name; });
}  // namespace

// From a guess of zero the errors are at most 15 mm and 0.2 degrees, and within 4 standard
// deviations of the covariance.
TEST_P(SimulatedPairs, EndWithinFourSigmaOfTheTruth)
{
  constexpr unsigned kSeeds = 5;
  constexpr double kSigmas = 4;
  const GoldenPair& p = GetParam();
  const LaserOptions scanner{BeamGrid::centered(degToRad(p.fieldOfView_deg), p.rays), p.maxRange_m,
                             p.rangeSigma_m};
  ASSERT_TRUE(p.world.isFree(p.T_world_ref.translation()));
  const Matcher matcher;
  MatcherWorkspace workspace;
  for (unsigned seed = 1; seed <= kSeeds; ++seed)
  {
    std::mt19937_64 random(seed);
    Scan reference = castScan(p.world, p.T_world_ref, scanner, random).scan;
    Scan current = castScan(p.world, p.T_world_ref * p.T_ref_cur, scanner, random).scan;
    const MatchResult result = matcher.match(reference, current, {}, workspace);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + result.report());
    ASSERT_TRUE(result.usable());
    EXPECT_TRUE(isNearly(result.T_ref_cur, p.T_ref_cur, 0.015, degToRad(0.2)));
    const Eigen::Vector3d e(result.T_ref_cur.x_m - p.T_ref_cur.x_m,
                            result.T_ref_cur.y_m - p.T_ref_cur.y_m,
                            wrapAngle(result.T_ref_cur.phi_rad - p.T_ref_cur.phi_rad));
    for (int i = 0; i < 3; ++i)
      EXPECT_LT(std::abs(e[i]), kSigmas * std::sqrt(result.covariance(i, i))) << "component " << i;
  }
}
}  // namespace psmks
