/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/UncertainPose.h>
#include <psmks/motion/Deskewer.h>
#include <psmks/motion/PlanarVelocity.h>

namespace psmks
{
/** Deskews the scans of a robot one after the other, by the motions that led to them and, where a
 * scan was taken in several turns of the beam, by what it tells itself. Scans stay as they are
 * while the robot stands by these motions, and where its velocity is not known (MeanVelocity). */
class SequenceDeskewer
{
 public:
  /** Takes the motion out of the next scan.
   *  @param scan with its stamp, in the order of time
   *  @param T_last_robot the motion of the robot since the scan before; of the first scan anything
   */
  void deskew(Scan& scan, const Pose2& T_robot_sensor, const UncertainPose& T_last_robot);

  /** The velocity of the sensor at the last scan, by the motions alone. */
  const PlanarVelocity& measured() const { return measured_; }

 private:
  MeanVelocity velocity_;
  PlanarVelocity measured_;
  Deskewer deskewer_;
};
}  // namespace psmks
