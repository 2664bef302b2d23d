/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/core/MatcherOptions.h>
#include <psmks/slam/TrajectoryBuilder.h>

#include <Eigen/Core>
#include <vector>

namespace psmks
{
/** What a trajectory shows of the world, in the world's frame: made for pictures and files. */
struct ScanMap
{
  struct Wall
  {
    Eigen::Vector2d from_m, to_m;
    int points;      //!< rays on it
    double sigma_m;  //!< of their distances from it
  };

  std::vector<Eigen::Vector2d> points_m;  //!< every valid return of every scan
  std::vector<Wall> walls;                //!< the segments of the reference scans
  std::vector<Pose2> path;                //!< of the robot, one pose a scan
  std::vector<Pose2> odometryPath;        //!< by odometry alone; empty where there was none
};

ScanMap makeScanMap(const std::vector<PosedScan>& scans, const MatcherOptions& options);
}  // namespace psmks
