/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/support/UnitHints.h>
#include <psmks/eval/Statistics.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <utility>

namespace psmks
{
namespace
{
std::string roundedText(double value)
{
  std::ostringstream out;
  out << std::setprecision(value >= 100 ? 6 : 3) << (value >= 100 ? std::round(value) : value);
  return out.str();
}

double medianRange_m(const std::vector<PosedScan>& scans)
{
  /** Scans that are looked at. Definition: enough for a median. */
  constexpr std::size_t kScans = 200;
  std::vector<double> ranges_m;
  for (std::size_t s = 0; s < scans.size(); s += scans.size() / kScans + 1)
    for (int ray = 0; ray < scans[s].scan.grid.count(); ++ray)
      if (isReturn(scans[s].scan, ray))
        ranges_m.push_back(scans[s].scan.range_m[static_cast<std::size_t>(ray)]);
  return ranges_m.empty() ? 0 : median(ranges_m);
}

double medianPeriod_s(const std::vector<PosedScan>& scans)
{
  std::vector<double> periods_s;
  for (std::size_t s = 1; s < scans.size(); ++s)
    if (const double period_s = scans[s].stamp_s() - scans[s - 1].stamp_s(); period_s > 0)
      periods_s.push_back(period_s);
  /** Where no stamps rise. Definition: a common scanner's. */
  constexpr double kUsual_s = 0.1;
  return periods_s.empty() ? kUsual_s : median(periods_s);
}

/** How fast the odometry drives where it does, and how fast it turns where it turns most. */
struct OdometrySpeed
{
  double drive_m_s = 0, turn_rad_s = 0;
};

OdometrySpeed odometrySpeed(const std::vector<PosedScan>& scans)
{
  /** Steps below the first are those of a robot that stands, and turns above the share of the
   * second are chance. Definition: the rounding of logs; one scan in twenty. */
  constexpr double kStanding_m = 1e-3, kMost = 0.95;
  std::vector<double> steps_m, turns_rad;
  for (std::size_t s = 1; s < scans.size(); ++s)
  {
    const Pose2 step = scans[s - 1].T_world_odometry.inverse() * scans[s].T_world_odometry;
    if (step.translation().norm() > kStanding_m) steps_m.push_back(step.translation().norm());
    turns_rad.push_back(std::abs(step.phi_rad));
  }
  if (steps_m.empty()) return {};
  const double period_s = medianPeriod_s(scans);
  return {median(steps_m) / period_s, quantile(turns_rad, kMost) / period_s};
}

/** The length of a path in steps of half a metre, so that noise of a robot that stands has none. */
template <class Path, class PlaceOf>
double length_m(const Path& path, PlaceOf placeOf)
{
  /** Definition: a robot's length. */
  constexpr double kStep_m = 0.5;
  double length_m = 0;
  Eigen::Vector2d last = path.empty() ? Eigen::Vector2d::Zero() : placeOf(path.front());
  for (const auto& pose : path)
  {
    const double step_m = (placeOf(pose) - last).norm();
    if (step_m < kStep_m) continue;
    length_m += step_m;
    last = placeOf(pose);
  }
  return length_m;
}

bool differGrossly(double a_m, double b_m)
{
  /** Definition: what neither slip nor a wrong wheel size explains. */
  constexpr double kTimes = 2, kLeast_m = 5;
  return std::abs(a_m - b_m) > kLeast_m && std::max(a_m, b_m) > kTimes * std::min(a_m, b_m);
}

/** The power of ten, of those that units differ by, that a ratio is about; 0 where it is none. */
int unitPower(double ratio)
{
  /** Definition: paths as large as each other to a quarter. */
  constexpr double kTolerance = 0.1;
  const double power = std::log10(ratio), whole = std::round(power);
  const bool isUnit = std::abs(whole) == 2 || std::abs(whole) == 3;
  return std::isfinite(power) && isUnit && std::abs(power - whole) < kTolerance
             ? static_cast<int>(whole)
             : 0;
}

const char* lengthUnit(int power) { return std::abs(power) == 2 ? "centimetres" : "millimetres"; }
}  // namespace

std::vector<std::string> unitHints(const std::vector<PosedScan>& scans)
{
  /** Largest median of ranges, fastest drive and turn. Definition: no 2D scanner's surroundings and
   * no robot's wheels reach half of them. */
  constexpr double kFarthest_m = 60, kFastest_m_s = 20, kFastest_rad_s = 2 * kPi;
  std::vector<std::string> hints;
  const double range_m = medianRange_m(scans);
  if (range_m > kFarthest_m)
    hints.push_back("half of the ranges are above " + roundedText(range_m) +
                    " m, are they in centimetres or millimetres?");
  if (!hasOdometry(scans)) return hints;
  const OdometrySpeed speed = odometrySpeed(scans);
  if (speed.drive_m_s > kFastest_m_s)
    hints.push_back("the odometry drives at " + roundedText(speed.drive_m_s) +
                    " m/s, is it in centimetres or millimetres?");
  if (speed.turn_rad_s > kFastest_rad_s)
    hints.push_back("the odometry turns at " + roundedText(speed.turn_rad_s) +
                    " rad/s, are its headings in degrees?");
  const double path_m =
      length_m(scans, [](const PosedScan& s) { return s.T_world_robot.pose.translation(); });
  const double odometry_m =
      length_m(scans, [](const PosedScan& s) { return s.T_world_odometry.translation(); });
  if (hints.empty() && differGrossly(path_m, odometry_m))
    hints.push_back("the path of the scans is " + roundedText(path_m) +
                    " m long, that of the odometry " + roundedText(odometry_m) +
                    " m: one of them is wrong");
  return hints;
}

std::vector<std::string> unitHints(const std::vector<CommonPose>& common)
{
  std::vector<std::string> hints;
  Eigen::AlignedBox2d estimate, truth;
  for (const CommonPose& pose : common)
  {
    estimate.extend(pose.T_estimated.translation());
    truth.extend(pose.T_true.translation());
  }
  if (common.empty()) return hints;
  const double estimate_m = estimate.diagonal().norm(), truth_m = truth.diagonal().norm();
  if (const int power = unitPower(truth_m / estimate_m))
    hints.push_back("the ground truth extends over " + roundedText(truth_m) +
                    " m and the estimate over " + roundedText(estimate_m) + " m, is " +
                    (power > 0 ? "the first" : "the second") + " in " + lengthUnit(power) + "?");
  return hints;
}

std::string stampHint(const Trajectory& estimate, const Trajectory& truth)
{
  const std::array<std::pair<int, const char*>, 3> units{
      {{3, "milliseconds"}, {6, "microseconds"}, {9, "nanoseconds"}}};
  const double power =
      std::log10(truth[truth.size() / 2].stamp_s / estimate[estimate.size() / 2].stamp_s);
  for (const auto& [digits, name] : units)
    if (std::abs(std::abs(power) - digits) < 0.5)
      return std::string(", are its stamps ") + (power > 0 ? "" : "in seconds and the other's ") +
             "in " + name + "?";
  return "";
}
}  // namespace psmks
