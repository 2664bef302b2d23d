/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/sim/PoseBound.h>
#include <psmks/sim/Simulation.h>
#include <psmks/sim/World.h>
#include <psmks/slam/PoseGraph.h>

#include <optional>
#include <vector>

namespace psmks
{
/** What a scan was matched against. */
struct FloorStep
{
  std::optional<std::size_t> reference;  //!< index of a scan before it; none = odometry counts
  bool joinsMap = false;                 //!< it becomes a keyframe ...
  std::vector<std::size_t> links;        //!< ... matched against these others too
};

/** The drift that remains when every match of a drive is made as well as it can be.
 *
 * Each scan's pose hangs on the one it was matched against, with the error that maximum likelihood
 * makes on the noise of these very two scans and of the wheels in between (mostLikelyError()). A
 * scan's noise enters the matches of both its sides, mostly with opposite sign: errors of
 * neighbouring matches cancel in part, which a floor of independent errors would miss.
 *
 *     start --odometry--> . --match--> . --match--> .
 *
 * Where keyframes are matched against several others, all these matches together fix their poses
 * (PoseGraph), anew with each keyframe that joins. */
class DriftFloor
{
 public:
  /** @param recording made in this world with the scanner at the centre of the robot; both must
   *  outlive the floor */
  DriftFloor(const World& world, const Recording& recording, const SimulationOptions& simulation);

  /** Where the robot would be thought to be when each scan came, in the world's frame.
   *  @param steps one a scan */
  std::vector<Pose2> poses(const std::vector<FloorStep>& steps) const;

 private:
  PoseLink matched(std::size_t reference, std::size_t current) const;
  PoseLink linked(std::size_t reference, std::size_t current) const;
  Pose2 measuredMotion(std::size_t reference, std::size_t current) const;
  Eigen::Matrix3d wheelCovariance(std::size_t reference, std::size_t current) const;

  const World& world_;
  const Recording& recording_;
  RobotOptions robot_;
  RangeNoise noise_;
  double scanPeriod_s_;
};
}  // namespace psmks
