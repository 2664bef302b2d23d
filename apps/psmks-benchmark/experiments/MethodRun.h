/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-benchmark/experiments/Drive.h>
#include <apps/psmks-benchmark/experiments/Method.h>
#include <psmks/core/MatcherOptions.h>
#include <psmks/sim/DriftBound.h>
#include <psmks/slam/TrajectoryBuilder.h>

#include <vector>

namespace psmks
{
/** The errors of the pose of the robot relative to its true start: dr and |dtheta| of the paper. */
struct DriftFigures
{
  double mean_m = 0, max_m = 0;
  double mean_rad = 0, max_rad = 0;
};

/** The errors of some scans of a drive.
 *  @param T_world_robot an estimated pose for each scan of the recording
 *  @param scans indices of those that count */
DriftFigures driftFigures(const Recording& recording, const std::vector<Pose2>& T_world_robot,
                          const std::vector<std::size_t>& scans);

/** The result of a method on a drive in numbers. Errors are those at the scans whose match was
 * accepted. */
struct MethodFigures
{
  DriftFigures drift;
  DriftFigures odometryDrift;  //!< errors of odometry at the same scans
  DriftFigures boundDrift;     //!< see DriftBound, on the same pairs of scans

  int matches = 0;          //!< number of accepted matches
  int failures = 0;         //!< number of refused matches
  int degenerate = 0;       //!< number accepted with an unobservable direction
  int silentErrors = 0;     //!< accepted without a flag, and wrong by more than 10 cm or 2 degrees
  double worstMatch_m = 0;  //!< largest error of accepted matches without a flag
  double worstMatch_rad = 0;
  double meanSegmentation_s = 0;  //!< time of a scan
  double meanMatch_s = 0;         //!< time of a match, without segmentation
  double wallEndsShare = 0;       //!< share of segment ends in the map within 3 cm of a true wall
};

/** The poses of the robot by odometry alone at all scans, in the frame of the world. */
std::vector<Pose2> odometryPoses(const Recording& recording);

/** The scans that each scan was matched against. */
std::vector<DriftBoundStep> driftBoundSteps(const std::vector<PosedScan>& scans);

struct MethodRun
{
  Method method;
  MethodFigures figures;
  std::vector<PosedScan> scans;      //!< final poses, in the frame of the first scan
  std::vector<Pose2> T_world_robot;  //!< estimated pose of each scan when it was added
  std::vector<std::size_t> matched;  //!< the scans whose match was accepted
};

/** Follows the robot of a drive by a method.
 *  @param options of the matchers of psmks */
MethodRun runMethod(const Drive& drive, const Method& method, const MatcherOptions& options,
                    const OdometryOptions& odometry);
}  // namespace psmks
