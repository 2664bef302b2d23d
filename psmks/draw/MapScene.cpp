/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <mrpt/opengl/CGridPlaneXY.h>
#include <mrpt/opengl/CPointCloud.h>
#include <mrpt/opengl/CSetOfLines.h>
#include <mrpt/opengl/stock_objects.h>
#include <psmks/draw/MapScene.h>
#include <psmks/mrpt/Convert.h>

#include <cmath>

namespace psmks
{
using mrpt::img::TColor;
using namespace mrpt::opengl;

namespace
{
/** Above the points, so that these do not hide them. */
constexpr double kWallHeight_m = 0.02, kPathHeight_m = 0.05;

CGridPlaneXY::Ptr makeGrid(const ScanMap& map)
{
  constexpr double kCell_m = 5;
  Eigen::Vector2d min = Eigen::Vector2d::Zero(), max = Eigen::Vector2d::Zero();
  for (const auto& p : map.points_m)
  {
    min = min.cwiseMin(p);
    max = max.cwiseMax(p);
  }
  const auto down = [](double x) { return static_cast<float>(kCell_m * std::floor(x / kCell_m)); };
  auto grid = CGridPlaneXY::Create(down(min.x()), -down(-max.x()), down(min.y()), -down(-max.y()),
                                   0.0f, static_cast<float>(kCell_m));
  grid->setColor_u8(TColor(210, 210, 210));
  return grid;
}

CPointCloud::Ptr makePoints(const ScanMap& map)
{
  auto cloud = CPointCloud::Create();
  for (const auto& p : map.points_m)
    cloud->insertPoint(static_cast<float>(p.x()), static_cast<float>(p.y()), 0.0f);
  cloud->setPointSize(2);
  cloud->setColor_u8(TColor(140, 170, 190));
  return cloud;
}

CSetOfLines::Ptr makeWalls(const ScanMap& map)
{
  auto lines = CSetOfLines::Create();
  for (const auto& wall : map.walls)
    lines->appendLine(wall.from_m.x(), wall.from_m.y(), kWallHeight_m, wall.to_m.x(), wall.to_m.y(),
                      kWallHeight_m);
  lines->setLineWidth(2);
  lines->setColor_u8(TColor(20, 40, 70));
  return lines;
}

CSetOfLines::Ptr makePath(const std::vector<Pose2>& path, const TColor& colour)
{
  auto lines = CSetOfLines::Create();
  for (std::size_t i = 1; i < path.size(); ++i)
    lines->appendLine(path[i - 1].x_m, path[i - 1].y_m, kPathHeight_m, path[i].x_m, path[i].y_m,
                      kPathHeight_m);
  lines->setLineWidth(3);
  lines->setColor_u8(colour);
  return lines;
}
}  // namespace

COpenGLScene::Ptr makeMapScene(const ScanMap& map)
{
  auto scene = COpenGLScene::Create();
  scene->insert(makeGrid(map));
  scene->insert(makePoints(map));
  scene->insert(makeWalls(map));
  scene->insert(makePath(map.odometryPath, TColor(255, 150, 140)));
  scene->insert(makePath(map.path, TColor(210, 50, 110)));
  if (!map.path.empty())
  {
    auto robot = stock_objects::RobotPioneer();
    robot->setPose(mrpt::poses::CPose3D(toMrpt(map.path.back())));
    scene->insert(robot);
  }
  return scene;
}
}  // namespace psmks
