/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/support/OdometryJumps.h>

#include <cmath>

namespace psmks
{
std::vector<OdometryJump> odometryJumps(const std::vector<PosedScan>& scans)
{
  /** Errors of odometry that are jumps. Definition: more than wheels slip between two scans. */
  constexpr double kJump_m = 1, kJump_rad = degToRad(45);
  std::vector<OdometryJump> jumps;
  if (!hasOdometry(scans)) return jumps;
  for (std::size_t s = 1; s < scans.size(); ++s)
  {
    const bool bothMatched = scans[s].isMatched() && (s == 1 || scans[s - 1].isMatched());
    if (!bothMatched) continue;
    const Pose2 byOdometry = scans[s - 1].T_world_odometry.inverse() * scans[s].T_world_odometry;
    const Pose2 off = scans[s].T_last_robot.pose.inverse() * byOdometry;
    const OdometryJump jump{s, off.translation().norm(), std::abs(wrapAngle(off.phi_rad))};
    if (jump.distance_m > kJump_m || jump.angle_rad > kJump_rad) jumps.push_back(jump);
  }
  return jumps;
}
}  // namespace psmks
