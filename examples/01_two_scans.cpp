/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */

/** \file
 * Example 1: the motion between two scans that are given as plain ranges, by psmks::core alone.
 *
 * A scanner stands in a rectangular room, drives 0.30 m ahead and 0.10 m to the left, and turns by
 * 7 degrees. The example makes up what the scanner measures at both places and prints what the
 * match finds: the status, the motion with its standard deviations, and how well it explains the
 * ranges. */

#include <psmks/core/align.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

// The distance to the walls x = -4 m, x = 4 m, y = -3 m and y = 3 m along every ray.
std::vector<double> rangesIn8x6Room(const psmks::Pose2& T_room_scanner, const psmks::BeamGrid& grid)
{
  std::vector<double> range_m;
  for (int ray = 0; ray < grid.count(); ++ray)
  {
    const Eigen::Vector2d direction = T_room_scanner.rotation() * grid.direction(ray);
    const double toSideWall_m =
        (std::copysign(4.0, direction.x()) - T_room_scanner.x_m) / direction.x();
    const double toEndWall_m =
        (std::copysign(3.0, direction.y()) - T_room_scanner.y_m) / direction.y();
    range_m.push_back(std::min(toSideWall_m, toEndWall_m));
  }
  return range_m;
}

int main()
{
  const psmks::BeamGrid grid = psmks::BeamGrid::centered(psmks::degToRad(270), 541);
  const std::vector<double> reference_m = rangesIn8x6Room({0.5, 0.2, 0}, grid);
  const std::vector<double> current_m = rangesIn8x6Room({0.8, 0.3, psmks::degToRad(7)}, grid);

  const psmks::MatchResult match = psmks::align(reference_m, current_m, grid);
  std::cout << match.report() << '\n';
  return match.usable() ? 0 : 1;
}
