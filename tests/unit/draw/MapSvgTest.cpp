/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/draw/MapSvg.h>
#include <tests/support/Says.h>

#include <sstream>

namespace psmks
{
namespace
{
using test::says;

//   4  o-----------o     a wall of 8 m above a path of 4 m; a frame of 10 x 6 m with its margin
//
//   0     s-->--e
//      0     x     8
ScanMap wallAndPath()
{
  ScanMap map;
  for (int i = 0; i <= 1000; ++i) map.points_m.push_back({8.0 * i / 1000, 4});
  map.walls.push_back({{0, 4}, {8, 4}, 1001, 0.01});
  map.path = {{2, 0, 0}, {6, 0, 0}};
  return map;
}

std::string drawn(const ScanMap& map, const std::string& title)
{
  std::ostringstream out;
  writeMapSvg(out, map, title);
  return out.str();
}

struct Point
{
  double x_px = 0, y_px = 0;
};

/** The first point after a text. */
Point pointAfter(const std::string& svg, const std::string& text)
{
  std::istringstream in(svg.substr(svg.find(text) + text.size()));
  Point point;
  in >> point.x_px;
  in.get();
  in >> point.y_px;
  return point;
}
}  // namespace

TEST(MapSvg, ItIsAHundredPixelsToTheMetreAndYGoesUp)
{
  const std::string svg = drawn(wallAndPath(), "room");
  const Point wall = pointAfter(svg, "<path id=\"segments\" d=\"M");
  const Point path = pointAfter(svg, "<polyline id=\"path\" points=\"");
  EXPECT_NEAR(path.x_px - wall.x_px, 200, 4);
  EXPECT_NEAR(path.y_px - wall.y_px, 400, 4);
}

TEST(MapSvg, TextsAreTextsAndNothingInThemIsMarkup)
{
  const std::string svg = drawn(wallAndPath(), "a <b> & c");
  EXPECT_TRUE(says(svg, {">a &lt;b&gt; &amp; c</text>", ">x, m</text>", ">4</text>",
                         ">1 segments of the reference scans</text>", ">start</text>"}));
}

TEST(MapSvg, AnEmptyMapIsAnEmptySheet)
{
  EXPECT_TRUE(says(drawn(ScanMap(), "nothing"), {"<svg", "</svg>"}));
}
}  // namespace psmks
