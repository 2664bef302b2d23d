/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/report/ScanOutline.h>
#include <gtest/gtest.h>

namespace psmks
{
namespace
{
/** A scan with rays one degree apart, the middle one straight ahead. */
Scan scanOf(const std::vector<double>& range_m)
{
  Scan scan;
  scan.grid = BeamGrid::centered(degToRad(static_cast<double>(range_m.size()) - 1),
                                 static_cast<int>(range_m.size()));
  scan.range_m = range_m;
  scan.maxRange_m = 10;
  return scan;
}
}  // namespace

TEST(ScanOutline, IsInCentimetresWithYDownwards)
{
  // bearings -1, 0, 1 deg at 2 m: y of -3.49, 0, 3.49 cm; SVG counts downwards
  EXPECT_EQ(outlinePath(scanOf({2, 2, 2})), "M0 0m200 3h0l0-3l0-3");
}

TEST(ScanOutline, AGapIsNotBridged)
{
  EXPECT_EQ(outlinePath(scanOf({2, 2, 4})), "M0 0m200 3h0l0-3m200-7h0");
}

TEST(ScanOutline, ShowsReturnsOnly)
{
  Scan scan = scanOf({0, 10, 2, std::numeric_limits<double>::quiet_NaN(), 2});
  scan.valid = {1, 1, 1, 1, 0};
  EXPECT_EQ(outlinePath(scan), "M0 0m200 0h0");
  ASSERT_EQ(returnPoints(scan).size(), 1U);
  EXPECT_TRUE(returnPoints(scan)[0].isApprox(Eigen::Vector2d(2, 0)));
}
}  // namespace psmks
