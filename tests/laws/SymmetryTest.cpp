/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <tests/laws/Schemes.h>

#include <algorithm>

namespace psmks
{
namespace
{
/** The scan after a reflection at the x axis, by which the bearing b becomes -b. */
Scan mirrored(Scan scan)
{
  std::reverse(scan.range_m.begin(), scan.range_m.end());
  const double last_rad = scan.grid.bearing_rad(scan.grid.count() - 1);
  scan.grid = BeamGrid(-last_rad, scan.grid.increment_rad(), scan.grid.count());
  return scan;
}

Pose2 mirrored(const Pose2& pose) { return {pose.x_m, -pose.y_m, -pose.phi_rad}; }

/** The same scan by a scanner that is mounted at another angle. */
Scan turned(Scan scan, double by_rad)
{
  scan.grid =
      BeamGrid(scan.grid.firstBearing_rad() + by_rad, scan.grid.increment_rad(), scan.grid.count());
  return scan;
}

Pose2 turned(const Pose2& pose, double by_rad)
{
  return Pose2{0, 0, by_rad} * pose * Pose2{0, 0, -by_rad};
}

class Symmetry : public SchemeLaw
{
};

INSTANTIATE_TEST_SUITE_P(Schemes, Symmetry, testing::ValuesIn(bothSchemes()), schemeName);
}  // namespace

TEST_P(Symmetry, AScanMatchesItselfAtTheIdentity)
{
  for (const BeamGrid& grid : {kHalfCircle, kFullCircle})
    for (int i = 0; i < kPairs; ++i)
    {
      const Scan scan = randomPair(grid).reference;
      const MatchResult result = match(scan, scan);
      EXPECT_TRUE(isNearly(result.T_ref_cur, {}, 1e-5, 1e-6)) << result.report();
    }
}

TEST_P(Symmetry, SwappingTheScansGivesTheInverse)
{
  for (const BeamGrid& grid : {kHalfCircle, kFullCircle})
    for (int i = 0; i < kPairs; ++i)
    {
      const ScanPair pair = randomPair(grid);
      const MatchResult forth = match(pair.reference, pair.current);
      EXPECT_TRUE(holds(match(pair.current, pair.reference), forth.T_ref_cur.inverse()))
          << forth.report();
    }
}

TEST_P(Symmetry, MirroringTheScansFlipsYAndTheHeading)
{
  for (const BeamGrid& grid : {kHalfCircle, kFullCircle})
    for (int i = 0; i < kPairs; ++i)
    {
      const ScanPair pair = randomPair(grid);
      const MatchResult plain = match(pair.reference, pair.current);
      EXPECT_TRUE(
          holds(match(mirrored(pair.reference), mirrored(pair.current)), mirrored(plain.T_ref_cur)))
          << plain.report();
    }
}

TEST_P(Symmetry, TurningTheBearingsConjugatesThePose)
{
  for (const double by_deg : {30., 90., 180., -123.})
    for (int i = 0; i < kPairs; ++i)
    {
      const ScanPair pair = randomPair(i % 2 ? kHalfCircle : kFullCircle);
      const double by_rad = degToRad(by_deg);
      const MatchResult plain = match(pair.reference, pair.current);
      EXPECT_TRUE(holds(match(turned(pair.reference, by_rad), turned(pair.current, by_rad)),
                        turned(plain.T_ref_cur, by_rad)))
          << "by " << by_deg << " deg, " << plain.report();
    }
}
}  // namespace psmks
