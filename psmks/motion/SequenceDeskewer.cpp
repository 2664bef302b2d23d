/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/motion/SequenceDeskewer.h>

namespace psmks
{
void SequenceDeskewer::deskew(Scan& scan, const Pose2& T_robot_sensor,
                              const UncertainPose& T_last_robot)
{
  velocity_.add(scan.stamp_s, T_last_robot);
  measured_ = velocityOfSensor(velocity_.velocity(), T_robot_sensor);
  if (measured_.isZero()) return;
  deskewer_.deskew(scan, deskewer_.fittedVelocity(scan, measured_, velocity_.covariance()));
}
}  // namespace psmks
