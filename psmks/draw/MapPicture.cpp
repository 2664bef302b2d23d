/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/draw/MapFrame.h>
#include <psmks/draw/MapLegend.h>
#include <psmks/draw/MapPicture.h>
#include <psmks/draw/MapSheet.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
using Colour = MapSheet::Colour;

const Colour kPoint(190, 170, 140);
const Colour kOdometry(130, 130, 130);

constexpr double kPathWidth = 2.2, kOdometryWidth = 1.2, kWallWidth = 1;  // hairlines

/** A colour between violet at the start and orange at the end, with red in the middle. */
Colour pathColour(double share)
{
  const Colour stops[] = {{170, 30, 90}, {110, 50, 210}, {20, 150, 250}};
  const int first = share < 0.5 ? 0 : 1;
  const double t = 2 * share - first;
  return stops[first] * (1 - t) + stops[first + 1] * t;
}

void drawColouredPath(MapSheet& sheet, const std::vector<Pose2>& path)
{
  for (std::size_t i = 1; i < path.size(); ++i)
    sheet.drawLine(path[i - 1].translation(), path[i].translation(),
                   pathColour(static_cast<double>(i) / static_cast<double>(path.size())),
                   kPathWidth);
}

/** Draws a path with dashes of equal length, whatever the spacing of its poses. */
void drawDashed(MapSheet& sheet, const std::vector<Pose2>& path, const Colour& colour)
{
  const double dash_m = 8 * sheet.strokes(1) * sheet.pixel_m();
  double way_m = 0;
  for (std::size_t i = 1; i < path.size(); ++i)
  {
    const Eigen::Vector2d a = path[i - 1].translation(), b = path[i].translation();
    const double length_m = (b - a).norm();
    const int pieces = std::max(1, static_cast<int>(std::ceil(4 * length_m / dash_m)));
    for (int k = 0; k < pieces; ++k)
    {
      const double from = static_cast<double>(k) / pieces, to = static_cast<double>(k + 1) / pieces;
      const bool ink = std::fmod(way_m + from * length_m, 2 * dash_m) < dash_m;
      if (ink) sheet.drawLine(a + from * (b - a), a + to * (b - a), colour, kOdometryWidth);
    }
    way_m += length_m;
  }
}

void drawLegend(MapSheet& sheet, const ScanMap& map, const std::string& title)
{
  MapLegend legend(sheet);
  legend.add(title);
  legend.addLine("points of " + std::to_string(map.path.size()) + " scans", kPoint, 2);
  legend.addLine("segments of the reference scans", ink::kWall, kWallWidth);
  legend.addShades(
      "path, from start to end",
      {pathColour(0), pathColour(0.25), pathColour(0.5), pathColour(0.75), pathColour(1)},
      kPathWidth);
  if (!map.odometryPath.empty()) legend.addDashes("odometry alone", kOdometry, kOdometryWidth);
  legend.addEnds();
  legend.draw();
}
}  // namespace

bool saveMapPicture(const ScanMap& map, const std::string& title, const std::string& path)
{
  if (map.points_m.empty() || map.path.empty()) return false;
  MapSheet sheet(frameOf(map));
  sheet.drawGrid();
  sheet.drawPoints(map.points_m, kPoint);
  for (const auto& wall : map.walls) sheet.drawLine(wall.from_m, wall.to_m, ink::kWall, kWallWidth);
  drawDashed(sheet, map.odometryPath, kOdometry);
  drawColouredPath(sheet, map.path);
  sheet.drawEnds(placesOf(map.path));
  drawLegend(sheet, map, title);
  return sheet.save(path);
}
}  // namespace psmks
