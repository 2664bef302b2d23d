/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/core/MatcherOptions.h>
#include <psmks/slam/TrajectoryBuilder.h>

#include <Eigen/Core>
#include <vector>

namespace psmks
{
/** What the scans of a trajectory show, in the frame of the world, for pictures and files. */
struct ScanMap
{
  /** A segment of a scan. */
  struct Wall
  {
    Eigen::Vector2d from_m, to_m;
    int points;      //!< number of rays on it
    double sigma_m;  //!< standard deviation of their distances from it
  };

  std::vector<Eigen::Vector2d> points_m;  //!< the valid returns of all scans, but for the moving
  std::vector<Eigen::Vector2d> moving_m;  //!< returns of what has moved, see MovingReturns
  std::vector<Wall> walls;                //!< the segments of the scans that were references, but
                                          //!< for those of which most rays met what has moved
  std::vector<Pose2> path;                //!< T_world_robot, one for each scan
  std::vector<Pose2> odometryPath;        //!< T_world_odometry, one for each scan; empty where the
                                          //!< odometry never moved
};

/** Puts the returns of all scans and the walls of the references at their poses in the world.
 *  @param options those of the matcher, by which each scan is segmented once more, with the noise
 *      that it shows itself */
ScanMap makeScanMap(const std::vector<PosedScan>& scans, const MatcherOptions& options);
}  // namespace psmks
