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
/** The scans that a scan was matched against. */
struct DriftBoundStep
{
  std::optional<std::size_t> reference;  //!< index of an earlier scan; none = odometry alone
  bool joinsMap = false;                 //!< whether it becomes a keyframe
  std::vector<std::size_t> links;        //!< further keyframes that it was matched against
};

/** The drift of a drive if each of its matches has the error of the maximum likelihood estimate.
 * The drift of a real matcher on the same pairs of scans is compared with it.
 *
 * The pose of a scan follows from that of the scan it was matched against and from the error that
 * maximum likelihood makes with the noise of these two scans and of the wheels between them
 * (mostLikelyError()). The noise of a scan enters the match with its reference and the match in
 * which it is the reference, mostly with opposite sign, so that errors of neighbouring matches
 * cancel in part. A bound from independent errors would be too large.
 *
 *     start --odometry--> . --match--> . --match--> .
 *
 * If keyframes are matched against several others, their poses follow from all these matches
 * together, by a pose graph that is optimised with each new keyframe. */
class DriftBound
{
 public:
  /** @param recording made in this world, with the scanner at the centre of the robot; both
   *      must outlive this object */
  DriftBound(const World& world, const Recording& recording, const SimulationOptions& simulation);

  /** The estimated poses of the robot at the time of each scan, in the frame of the world.
   *  @param steps one for each scan */
  std::vector<Pose2> poses(const std::vector<DriftBoundStep>& steps) const;

  /** The same once all matches are known: the keyframes where all links together place them, every
   * other scan beside its reference.
   *  @param steps one for each scan */
  std::vector<Pose2> settledPoses(const std::vector<DriftBoundStep>& steps) const;

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
