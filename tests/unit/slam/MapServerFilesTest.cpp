/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/slam/MapServerFiles.h>

#include <sstream>
#include <string>

namespace psmks
{
namespace
{
//     row 1    S  -  X  ?      a ray along the upper row; x from -1 to 1, y from 2 to 3
//     row 0    ?  ?  ?  ?
OccupancyGrid smallGrid()
{
  OccupancyGrid grid(UniformGrid({-1, 2}, {1, 3}, 0.5));
  SegmentedScan scan;
  scan.grid = BeamGrid(0, degToRad(90), 1);
  scan.range_m = {1.0};
  scan.valid = {1};
  grid.add(scan, {-0.75, 2.75, 0});
  return grid;
}
}  // namespace

TEST(MapServerFiles, ThePictureHasTheHighestRowFirst)
{
  std::ostringstream out;
  writeMapServerPicture(out, smallGrid());
  const std::string head = "P5\n4 2\n255\n";
  ASSERT_EQ(out.str().size(), head.size() + 8);
  EXPECT_EQ(out.str().substr(0, head.size()), head);
  EXPECT_EQ(out.str().substr(head.size()),
            "\xFE\xFE" + std::string(1, '\0') + "\x80\x80\x80\x80\x80");
}

TEST(MapServerFiles, TheYamlSaysWhatThePictureMeans)
{
  std::ostringstream out;
  writeMapServerYaml(out, smallGrid(), "map.pgm");
  EXPECT_EQ(out.str(),
            "image: map.pgm\nmode: trinary\nresolution: 0.5\norigin: [-1, 2, 0]\nnegate: 0\n"
            "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
}
}  // namespace psmks
