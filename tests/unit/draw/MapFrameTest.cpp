/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/draw/MapFrame.h>

namespace psmks
{
using Coordinates = std::vector<double>;

TEST(MapFrame, HoldsThePathAndAllButTheFarthestPoints)
{
  ScanMap map;
  for (int i = 0; i < 1000; ++i) map.points_m.push_back({0.01 * i, 3});
  map.points_m.push_back({500, -500});
  map.path = {{-5, 0, 0}};
  const MapFrame frame = frameOf(map);
  EXPECT_NEAR(frame.min_m.x(), -6, 1e-9);
  EXPECT_NEAR(frame.max_m.x(), 11, 0.1);
  EXPECT_NEAR(frame.min_m.y(), -1, 1e-9);
  EXPECT_NEAR(frame.max_m.y(), 4, 1e-9);
}

TEST(MapFrame, ItsGridLiesAtRoundCoordinates)
{
  const MapFrame frame{{-1, 0.5}, {39, 9}};
  EXPECT_EQ(frame.gridSpacing_m(), 10);
  EXPECT_EQ(frame.gridCoordinates_m(0), Coordinates({0, 10, 20, 30}));
  EXPECT_EQ(frame.gridCoordinates_m(1), Coordinates());
}

TEST(MapFrame, CoordinatesAreTextsWithoutZerosAtTheirEnd)
{
  EXPECT_EQ(lengthText(0.5), "0.5");
  EXPECT_EQ(lengthText(-20), "-20");
}
}  // namespace psmks
