/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/eval/NumberRows.h>
#include <psmks/eval/Trajectory.h>
#include <psmks/geometry/Angle.h>

#include <cmath>
#include <iomanip>
#include <optional>
#include <ostream>

namespace psmks
{
namespace
{
double yawOf(double qx, double qy, double qz, double qw)
{
  return std::atan2(2 * (qw * qz + qx * qy), 1 - 2 * (qy * qy + qz * qz));
}

std::optional<StampedPose> poseOf(const std::vector<double>& n)
{
  if (n.size() == 8) return StampedPose{n[0], {n[1], n[2], yawOf(n[4], n[5], n[6], n[7])}};
  if (n.size() == 4) return StampedPose{n[0], {n[1], n[2], wrapAngle(n[3])}};
  return std::nullopt;
}
}  // namespace

Trajectory readTrajectory(const std::string& path, StampOrder order)
{
  Trajectory trajectory;
  for (const NumberRow& row : readNumberRows(path, "pose"))
  {
    const auto pose = poseOf(row.numbers);
    if (!pose) refuse(path, row, "expected 'stamp x y z qx qy qz qw' or 'stamp x y phi'");
    const bool isEarlier = !trajectory.empty() && pose->stamp_s < trajectory.back().stamp_s;
    if (isEarlier && order == StampOrder::Rising)
      refuse(path, row, "the stamp is earlier than that of the line before");
    trajectory.push_back(*pose);
  }
  return trajectory;
}

void writeTum(std::ostream& out, const Trajectory& trajectory)
{
  out << std::fixed;
  for (const auto& [stamp_s, pose] : trajectory)
  {
    out << std::setprecision(9) << stamp_s << ' ' << pose.x_m << ' ' << pose.y_m << " 0 0 0 "
        << std::sin(pose.phi_rad / 2) << ' ' << std::cos(pose.phi_rad / 2) << '\n';
  }
}

void writeMrptGroundTruth(std::ostream& out, const Trajectory& trajectory)
{
  out << std::fixed << std::setprecision(9);
  for (const auto& [stamp_s, pose] : trajectory)
    out << stamp_s << ' ' << pose.x_m << ' ' << pose.y_m << ' ' << pose.phi_rad << '\n';
}
}  // namespace psmks
