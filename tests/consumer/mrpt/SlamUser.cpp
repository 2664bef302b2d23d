/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/slam/OnlineSlam.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace
{
/** A room of 8 m x 6 m, seen from a place between its walls. */
psmks::Scan roomFrom(double x_m)
{
  psmks::Scan scan;
  scan.grid = psmks::BeamGrid::centered(2 * psmks::kPi, 360);
  for (int i = 0; i < scan.grid.count(); ++i)
  {
    const Eigen::Vector2d u = scan.grid.direction(i);
    const double wallX_m = std::copysign(4, u.x()), wallY_m = std::copysign(3, u.y());
    scan.range_m.push_back(std::min((wallX_m - x_m) / u.x(), wallY_m / u.y()));
  }
  return scan;
}
}  // namespace

/** Drives 0.3 m through the room and asks where it stands. */
int main()
{
  psmks::OnlineSlam slam;
  slam.addScan(roomFrom(0));
  const psmks::Pose2 pose = slam.addScan(roomFrom(0.3)).T_world_robot.pose;
  std::cout << pose.x_m << " m, " << pose.y_m << " m\n";
  return std::hypot(pose.x_m - 0.3, pose.y_m) < 1e-3 ? 0 : 1;
}
