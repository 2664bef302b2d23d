/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-benchmark/experiments/Drive.h>
#include <apps/psmks-benchmark/experiments/Method.h>
#include <psmks/core/MatcherOptions.h>
#include <psmks/slam/TrajectoryBuilder.h>

#include <vector>

namespace psmks
{
/** Errors of the robot's pose, seen from the true start: the paper's dr and |dtheta|. */
struct DriftFigures
{
  double mean_m = 0, max_m = 0;
  double mean_rad = 0, max_rad = 0;
};

/** What a method made of a drive, in numbers. Errors count at the scans whose match was accepted.
 */
struct MethodFigures
{
  DriftFigures drift;
  DriftFigures odometryDrift;  //!< at the same scans
  DriftFigures boundDrift;     //!< of the drift floor on the same pairs of scans

  int matches = 0;          //!< accepted
  int failures = 0;         //!< refused
  int degenerate = 0;       //!< accepted with a direction flagged as not observable
  int silentErrors = 0;     //!< accepted, not flagged, and wrong by more than 10 cm or 2 degrees
  double worstMatch_m = 0;  //!< of the accepted matches that are not flagged
  double worstMatch_rad = 0;
  double meanSegmentation_s = 0;  //!< of a scan
  double meanMatch_s = 0;         //!< of a match, without segmentation
  double wallEndsShare = 0;       //!< of the map's segment ends, those within 3 cm of a true wall
};

/** Where the odometry alone puts the robot, for every scan, in the world's frame. */
std::vector<Pose2> odometryPoses(const Recording& recording);

struct MethodRun
{
  Method method;
  MethodFigures figures;
  std::vector<PosedScan> scans;      //!< in the frame of the first; settled at the end
  std::vector<Pose2> T_world_robot;  //!< estimated when the scan came, one pose a scan
  std::vector<std::size_t> matched;  //!< the scans whose match was accepted
};

/** Follows the robot of a drive.
 *  @param options of our matchers */
MethodRun runMethod(const Drive& drive, const Method& method, const MatcherOptions& options,
                    const OdometryOptions& odometry);
}  // namespace psmks
