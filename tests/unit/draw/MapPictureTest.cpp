/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/draw/MapPicture.h>
#include <tests/support/ScratchFolder.h>

#include <fstream>

namespace psmks
{
namespace
{
/** A wall of points along x from 0 to `length_m`, seen from a path below it. */
ScanMap wallMap(double length_m)
{
  ScanMap map;
  for (int i = 0; i <= 1000; ++i) map.points_m.push_back({length_m * i / 1000, 5});
  map.walls.push_back({{0, 5}, {length_m, 5}, 1001, 0.01});
  map.path = {{1, 0, 0}, {length_m - 1, 0, 0}};
  return map;
}

/** The width of a PNG, which is in its bytes 16 to 19 in big-endian order. */
int widthOfPng_px(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  file.seekg(16);
  int width_px = 0;
  for (int byte = 0; byte < 4; ++byte) width_px = 256 * width_px + file.get();
  return width_px;
}

/** Width of a picture over that of its map. */
constexpr double kWithMargins = 1.1;

class MapPictureTest : public testing::Test
{
 protected:
  const test::ScratchFolder folder_;
  const std::string path_ = folder_.path("map.png");
};

TEST_F(MapPictureTest, TwoCentimetresAPixelButNeitherTooFewNorTooManyPixels)
{
  ASSERT_TRUE(saveMapPicture(wallMap(40), "title", path_));
  // 1 m of the world on either side of the wall, and the margin for the numbers
  EXPECT_NEAR(widthOfPng_px(path_), (40 + 2) / 0.02 * kWithMargins, 0.05 * 2100);
  ASSERT_TRUE(saveMapPicture(wallMap(8), "title", path_));
  EXPECT_NEAR(widthOfPng_px(path_), 1200 * kWithMargins, 0.05 * 1200);
  ASSERT_TRUE(saveMapPicture(wallMap(4000), "title", path_));
  EXPECT_NEAR(widthOfPng_px(path_), 4000 * kWithMargins, 0.05 * 4000);
}

TEST_F(MapPictureTest, AnEmptyMapAndAFolderThatIsMissingGiveNoPicture)
{
  EXPECT_FALSE(saveMapPicture(ScanMap(), "title", path_));
  EXPECT_FALSE(saveMapPicture(wallMap(40), "title", "/no/such/folder/map.png"));
}
}  // namespace
}  // namespace psmks
