/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */

/** \file
 * Example 4: from the log of a robot to a map and a trajectory.
 *
 * Reads an MRPT rawlog or a CARMEN log, by default one that Debian's package mrpt-common installs,
 * and writes into the current folder map.png, the map with the robot's path, and trajectory.tum, a
 * pose a line: time, position and quaternion. It prints how many scans there were, how many of them
 * were matched, and how far the robot drove. psmks-slam does the same with more files and options.
 */

#include <psmks/draw/MapPicture.h>
#include <psmks/eval/Trajectory.h>
#include <psmks/logs/OpenLog.h>
#include <psmks/mrpt/ObservationSlam.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <string>

constexpr const char* kLog =
    "/usr/share/mrpt/datasets/2006-01ENE-21-SENA_Telecom Faculty_one_loop_only.rawlog";

int main(int argc, char** argv)
{
  const std::string path = argc > 1 ? argv[1] : kLog;
  const auto log = psmks::openLog(path);
  psmks::ObservationSlam slam;
  psmks::LaserFrame frame;
  while (log->next(frame))
  {
    if (frame.odometry) slam.addMotion(psmks::toMrpt(*frame.odometry));
    slam.addScan(*frame.scan);
  }
  if (!log->damage().empty()) std::cerr << path << ": " << log->damage() << '\n';
  if (slam.scans().empty()) return 1;
  slam.optimise();  // loops that closed late move what was driven before

  psmks::Trajectory trajectory;
  int matched = 0;
  double way_m = 0;
  for (const psmks::PosedScan& scan : slam.scans())
  {
    const psmks::Pose2& T_world_robot = scan.T_world_robot.pose;
    if (!trajectory.empty())
      way_m += (T_world_robot.translation() - trajectory.back().pose.translation()).norm();
    trajectory.push_back({scan.stamp_s(), T_world_robot});
    if (scan.isMatched()) ++matched;
  }
  std::ofstream file("trajectory.tum");
  psmks::writeTum(file, trajectory);
  const psmks::ScanMap map = psmks::makeScanMap(slam.scans(), psmks::MatcherOptions());
  const bool isDrawn = psmks::saveMapPicture(map, "psmks", "map.png");

  std::cout << slam.scans().size() << " scans, " << matched << " of them matched, "
            << std::lround(way_m) << " m driven\n";
  return file && isDrawn ? 0 : 1;
}
