/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/slam/Overlap.h>
#include <tests/support/Scenes.h>

#include <limits>

namespace psmks
{
namespace
{
const BeamGrid kAround = BeamGrid::centered(2 * kPi, 360);
const BeamGrid kForward = BeamGrid::centered(kPi, 181);

Scan officeScan(const Pose2& T_world_sensor, const BeamGrid& grid)
{
  return castScan(officeRoom(), T_world_sensor, grid);
}
}  // namespace

TEST(Overlap, OfAScanWithItselfIsWhole)
{
  const Scan scan = officeScan({}, kForward);
  EXPECT_EQ(overlap(scan, scan, {}), 1);
}

TEST(Overlap, OfScansBackToBackIsNone)
{
  const Pose2 turned{0, 0, kPi};
  EXPECT_LT(overlap(officeScan({}, kForward), officeScan(turned, kForward), turned), 0.05);
}

TEST(Overlap, IsTheShareOfTheCurrentScan)
{
  const Scan around = officeScan({}, kAround), forward = officeScan({}, kForward);
  EXPECT_NEAR(overlap(around, forward, {}), 1, 1e-9);
  EXPECT_NEAR(overlap(forward, around, {}), 0.5, 0.02);
}

TEST(Overlap, BearsAPoseThatIsOffByDecimetres)
{
  const Pose2 moved{0.4, 0.2, degToRad(10)}, guess{0.5, 0.1, degToRad(12)};
  EXPECT_GT(overlap(officeScan({}, kAround), officeScan(moved, kAround), guess), 0.9);
  EXPECT_LT(overlap(officeScan({}, kAround), officeScan(moved, kAround), {2.5, 1, 0}), 0.5);
}

//   +--------++--------+     two rooms side by side: they share the faces of one wall, a quarter of
//   |  ref   ||  cur   |     what either sees
//   +--------++--------+
TEST(Overlap, AtTwoSidesOfAWallIsSmall)
{
  const std::vector<Wall> left = box({0, 0}, 6, 6), right = box({6.1, 0}, 6, 6);
  const Pose2 T_ref_cur{6.1, 0, 0};
  const double shared =
      overlap(castScan(left, {}, kAround), castScan(right, T_ref_cur, kAround), T_ref_cur);
  EXPECT_GT(shared, 0.2);
  EXPECT_LT(shared, 0.4);
}

// Only the ray behind, between whose neighbours the seam of the grid lies, looks at what is shared.
TEST(Overlap, ReachesAcrossTheSeamOfAClosedScan)
{
  Scan reference = officeScan({}, kAround);
  const double behind_m = reference.range_m.front();
  reference.range_m.front() = 0;
  Scan current;
  current.grid = BeamGrid(kPi - degToRad(0.4), degToRad(0.1), 1);
  current.range_m = {behind_m};
  EXPECT_EQ(overlap(reference, current, {}), 1);
}

//   sensor o--------------> | 10 m       a return of the current scan counts as seen where it lies
//                     <-0.8-> m          within 0.3 m + 5 % of what the reference measured there
TEST(Overlap, BearsRangesThatAreOffByThirtyCentimetresAndFivePerCent)
{
  const auto single = [](double range_m)
  {
    Scan scan;
    scan.grid = BeamGrid(0, degToRad(1), 1);
    scan.range_m = {range_m};
    return scan;
  };
  EXPECT_EQ(overlap(single(10), single(10.8), {}), 1);  // the tolerance at 10.8 m is 0.84 m
  EXPECT_EQ(overlap(single(10), single(9.25), {}), 1);  // at 9.25 m 0.76 m
  EXPECT_EQ(overlap(single(10), single(11), {}), 0);
  EXPECT_EQ(overlap(single(10), single(9.2), {}), 0);
}

TEST(Overlap, CountsReturnsOutsideTheFieldOfViewAsUnseen)
{
  const Scan forward = officeScan({}, kForward);
  const Pose2 turned{0, 0, degToRad(90)};
  EXPECT_NEAR(overlap(forward, officeScan(turned, kForward), turned), 0.5, 0.02);
}

TEST(Overlap, OfAStrideLooksAtEveryRayOfThatNumber)
{
  Scan scan = officeScan({}, kForward);
  Scan current = scan;
  for (std::size_t ray = 0; ray < current.range_m.size(); ++ray)
    if (ray % 5 != 0) current.range_m[ray] += 3;
  EXPECT_EQ(Overlap(scan, current, 5).at({}), 1);
  EXPECT_LT(Overlap(scan, current, 1).at({}), 0.5);
}

TEST(Overlap, OfScansThatDoNotFitTheirGridIsNone)
{
  const Scan whole = officeScan({}, kForward);
  Scan tooShort = whole, unflagged = whole;
  tooShort.range_m.resize(10);
  unflagged.valid = {0, 0, 0};
  EXPECT_EQ(overlap(whole, tooShort, {}), 0);
  EXPECT_EQ(overlap(tooShort, whole, {}), 0);
  EXPECT_EQ(overlap(whole, unflagged, {}), 1);
}

TEST(Overlap, WithoutReturnsIsNone)
{
  const Scan office = officeScan({}, kForward);
  Scan far = office, invalid = office, nothing = office;
  far.maxRange_m = 0.1;
  invalid.valid.assign(invalid.range_m.size(), 0);
  nothing.range_m.assign(nothing.range_m.size(), std::numeric_limits<double>::quiet_NaN());
  for (const Scan& empty : {far, invalid, nothing, Scan()})
  {
    EXPECT_EQ(overlap(office, empty, {}), 0);
    EXPECT_EQ(overlap(empty, office, {}), 0);
  }
}
}  // namespace psmks
