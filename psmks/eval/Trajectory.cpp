/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/eval/NumberRows.h>
#include <psmks/eval/Trajectory.h>
#include <psmks/geometry/Angle.h>

#include <Eigen/Geometry>
#include <cmath>
#include <iomanip>
#include <limits>
#include <optional>
#include <ostream>

namespace psmks
{
namespace
{
constexpr double kNoHeading = std::numeric_limits<double>::quiet_NaN();

/** The heading that a quaternion of any length states; NaN where it states none. */
double yawOf(double qx, double qy, double qz, double qw)
{
  /** Squared length of a quaternion that is zero. Definition: six digits of it. */
  constexpr double kZero = 1e-12;
  const double length2 = qx * qx + qy * qy + qz * qz + qw * qw;
  if (!(length2 > kZero) || !std::isfinite(length2)) return kNoHeading;
  return std::atan2(2 * (qw * qz + qx * qy), qw * qw + qx * qx - qy * qy - qz * qz);
}

std::optional<StampedPose> poseOf(const std::vector<double>& n)
{
  if (n.size() == 8) return StampedPose{n[0], {n[1], n[2], yawOf(n[4], n[5], n[6], n[7])}};
  if (n.size() == 4) return StampedPose{n[0], {n[1], n[2], wrapAngle(n[3])}};
  return std::nullopt;
}

bool hasPosition(const StampedPose& p)
{
  return std::isfinite(p.stamp_s) && std::isfinite(p.pose.x_m) && std::isfinite(p.pose.y_m);
}

/** Whether all headings are zero although the path turns. */
bool isWithoutHeadings(const Trajectory& trajectory)
{
  /** Extent of a path that turns, to both directions. Definition: more than a robot slides. */
  constexpr double kTurns_m = 1;
  Eigen::AlignedBox2d box;
  for (const StampedPose& p : trajectory)
  {
    if (p.pose.phi_rad != 0) return false;
    box.extend(p.pose.translation());
  }
  return box.sizes().minCoeff() > kTurns_m;
}

/** Leaves the headings out where the file does not state them. */
void settleHeadings(TrajectoryFile& file)
{
  const bool none = isWithoutHeadings(file.trajectory);
  for (StampedPose& p : file.trajectory)
  {
    if (none || !std::isfinite(p.pose.phi_rad)) p.pose.phi_rad = kNoHeading;
    if (!p.hasHeading()) ++file.posesWithoutHeading;
  }
}

std::string ofRows(int count, int all, const char* without)
{
  return std::to_string(count) + " of " + std::to_string(all) + " rows " +
         (count == 1 ? "has no " : "have no ") + without;
}
}  // namespace

std::vector<std::string> TrajectoryFile::remarks() const
{
  std::vector<std::string> remarks;
  if (rowsWithoutPosition > 0)
    remarks.push_back(ofRows(rowsWithoutPosition, rows, "position, left out"));
  if (posesWithoutHeading > 0)
    remarks.push_back(ofRows(posesWithoutHeading, rows, "heading, only the position counts"));
  return remarks;
}

TrajectoryFile readTrajectoryFile(const std::string& path, StampOrder order)
{
  TrajectoryFile file;
  Trajectory& trajectory = file.trajectory;
  for (const NumberRow& row : readNumberRows(path, "pose", NonFinite::Admitted))
  {
    const auto pose = poseOf(row.numbers);
    if (!pose) refuse(path, row, "expected 'stamp x y z qx qy qz qw' or 'stamp x y phi'");
    ++file.rows;
    if (!hasPosition(*pose))
    {
      ++file.rowsWithoutPosition;
      continue;
    }
    const bool isEarlier = !trajectory.empty() && pose->stamp_s < trajectory.back().stamp_s;
    if (isEarlier && order == StampOrder::Rising)
      refuse(path, row, "the stamp is earlier than that of the line before");
    trajectory.push_back(*pose);
  }
  if (trajectory.empty())
    throw TrajectoryFileError(path + ": none of its " + std::to_string(file.rows) +
                              " rows has a position");
  settleHeadings(file);
  return file;
}

Trajectory readTrajectory(const std::string& path, StampOrder order)
{
  return readTrajectoryFile(path, order).trajectory;
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
