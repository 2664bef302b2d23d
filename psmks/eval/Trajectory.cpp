/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/core/Angle.h>
#include <psmks/eval/NumberRows.h>
#include <psmks/eval/Trajectory.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
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

Pose2 interpolated(const StampedPose& a, const StampedPose& b, double stamp_s)
{
  const double span_s = b.stamp_s - a.stamp_s;
  const double share = span_s > 0 ? (stamp_s - a.stamp_s) / span_s : 0;
  return {a.pose.x_m + share * (b.pose.x_m - a.pose.x_m),
          a.pose.y_m + share * (b.pose.y_m - a.pose.y_m),
          wrapAngle(a.pose.phi_rad + share * wrapAngle(b.pose.phi_rad - a.pose.phi_rad))};
}

std::optional<Pose2> poseAt(const Trajectory& trajectory, double stamp_s)
{
  const auto after = std::lower_bound(trajectory.begin(), trajectory.end(), stamp_s,
                                      [](const StampedPose& p, double t) { return p.stamp_s < t; });
  if (after == trajectory.end()) return std::nullopt;
  if (after->stamp_s == stamp_s) return after->pose;
  if (after == trajectory.begin()) return std::nullopt;
  const auto before = std::prev(after);
  if (after->stamp_s - before->stamp_s > kMaxGap_s) return std::nullopt;
  return interpolated(*before, *after, stamp_s);
}

/** Mean, root of the mean square and maximum of what is added. */
struct Tally
{
  double sum = 0, squares = 0, max = 0;
  void add(double x)
  {
    sum += x;
    squares += x * x;
    max = std::max(max, x);
  }
};
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

TrajectoryError trajectoryError(const Trajectory& estimate, const Trajectory& truth)
{
  Tally position, heading;
  std::size_t poses = 0;
  Pose2 T_truth_estimate;  // of the two worlds
  for (const auto& [stamp_s, pose] : estimate)
  {
    const auto truePose = poseAt(truth, stamp_s);
    if (!truePose) continue;
    if (poses++ == 0) T_truth_estimate = *truePose * pose.inverse();
    const Pose2 error = truePose->inverse() * T_truth_estimate * pose;
    position.add(error.translation().norm());
    heading.add(std::abs(error.phi_rad));
  }
  if (poses == 0)
  {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    return {0, kNone, kNone, kNone, kNone, kNone, kNone};
  }
  const double n = static_cast<double>(poses);
  return {poses,        position.sum / n, std::sqrt(position.squares / n),
          position.max, heading.sum / n,  std::sqrt(heading.squares / n),
          heading.max};
}
}  // namespace psmks
