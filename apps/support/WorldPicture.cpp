/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/support/WorldPicture.h>
#include <psmks/draw/MapLegend.h>
#include <psmks/draw/MapSheet.h>

#include <Eigen/Geometry>

namespace psmks
{
namespace
{
using Colour = MapSheet::Colour;

const Colour kPoint(110, 60, 0);
const Colour kRoute(110, 190, 90);
const Colour kPath(110, 50, 210);
const Colour kMoving(20, 140, 250);

constexpr double kMargin_m = 1.0;
constexpr double kWallWidth = 2, kRouteWidth = 3, kPathWidth = 1.2, kMovingWidth = 1;  // hairlines

std::vector<Eigen::Vector2d> pointsOf(const World& world)
{
  std::vector<Eigen::Vector2d> points_m;
  for (const auto& point : world.points()) points_m.push_back(point.centre_m);
  return points_m;
}

/** A box around everything that is drawn. */
Eigen::AlignedBox2d boundsOf(const WorldPicture& picture)
{
  Eigen::AlignedBox2d bounds;
  for (const auto& wall : picture.world.walls()) bounds.extend(wall.a).extend(wall.b);
  for (const auto& point : picture.world.points()) bounds.extend(point.centre_m);
  for (const auto& object : picture.world.movingObjects())
    for (const auto& p : object.path_m) bounds.extend(p);
  for (const auto& p : picture.route) bounds.extend(p);
  for (const auto& pose : picture.path) bounds.extend(pose.translation());
  return bounds;
}

void drawWorld(MapSheet& sheet, const World& world)
{
  sheet.drawPoints(pointsOf(world), kPoint);
  for (const auto& wall : world.walls()) sheet.drawLine(wall.a, wall.b, ink::kWall, kWallWidth);
}

void drawMovingObjects(MapSheet& sheet, const World& world)
{
  for (const auto& object : world.movingObjects())
  {
    sheet.drawPath(object.path_m, kMoving, kMovingWidth);
    sheet.drawMark(object.place_m(0), kMoving);
  }
}

void drawDrive(MapSheet& sheet, const std::vector<Eigen::Vector2d>& path_m)
{
  if (path_m.empty()) return;
  sheet.drawPath(path_m, kPath, kPathWidth);
  sheet.drawEnds(path_m);
}

void drawLegend(MapSheet& sheet, const WorldPicture& picture)
{
  const World& world = picture.world;
  MapLegend legend(sheet);
  legend.add(picture.title);
  if (!world.walls().empty())
    legend.addLine(std::to_string(world.walls().size()) + " walls", ink::kWall, kWallWidth);
  if (!world.points().empty())
    legend.addMark(std::to_string(world.points().size()) + " points", kPoint);
  if (!world.movingObjects().empty())
    legend.addMark(std::to_string(world.movingObjects().size()) + " people, with their ways",
                   kMoving);
  if (!picture.route.empty()) legend.addLine("route", kRoute, kRouteWidth);
  if (!picture.path.empty())
  {
    legend.addLine("true path", kPath, kPathWidth);
    legend.addEnds();
  }
  legend.draw();
}
}  // namespace

bool saveWorldPicture(const WorldPicture& picture, const std::string& path)
{
  const Eigen::AlignedBox2d bounds = boundsOf(picture);
  if (bounds.isEmpty()) return false;
  const Eigen::Vector2d margin_m = Eigen::Vector2d::Constant(kMargin_m);
  MapSheet sheet({bounds.min() - margin_m, bounds.max() + margin_m});
  sheet.drawGrid();
  sheet.drawPath(picture.route, kRoute, kRouteWidth);
  drawWorld(sheet, picture.world);
  drawMovingObjects(sheet, picture.world);
  drawDrive(sheet, placesOf(picture.path));
  drawLegend(sheet, picture);
  return sheet.save(path);
}
}  // namespace psmks
