/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/core/Overlap.h>

#include <cmath>

namespace psmks
{
namespace
{
// Every so many rays are looked at: a share needs no more.
constexpr int kStride = 4;

// How far a return may lie from what the reference saw: the pose is a guess, and the farther the
// return the more a wrong heading moves it.
constexpr double kTolerance_m = 0.3;
constexpr double kTolerancePerMetre = 0.05;

/** As in cleanScan(): ranges that do not fit the grid are no ranges. */
bool isWellFormed(const Scan& scan)
{
  return scan.range_m.size() == static_cast<std::size_t>(scan.grid.count());
}

bool isReturn(const Scan& scan, int ray)
{
  const auto i = static_cast<std::size_t>(ray);
  const double range_m = scan.range_m[i];
  const bool flaggedValid = scan.valid.size() != scan.range_m.size() || scan.valid[i] != 0;
  const bool inReach = scan.maxRange_m <= 0 || range_m < scan.maxRange_m;
  return flaggedValid && std::isfinite(range_m) && range_m > 0 && inReach;
}

bool isSeen(const Scan& reference, const Eigen::Vector2d& point_m)
{
  const double range_m = point_m.norm();
  const double index = reference.grid.index(std::atan2(point_m.y(), point_m.x()));
  const bool isInside = index >= 0 && index <= reference.grid.count() - 1;
  if (!isInside && !reference.grid.closed()) return false;
  const double tolerance_m = kTolerance_m + kTolerancePerMetre * range_m;
  for (const int step : {0, 1})
  {
    const int ray = reference.grid.neighbour(static_cast<int>(std::floor(index)), step);
    if (ray >= 0 && isReturn(reference, ray) &&
        std::abs(reference.range_m[static_cast<std::size_t>(ray)] - range_m) < tolerance_m)
      return true;
  }
  return false;
}
}  // namespace

double overlap(const Scan& reference, const Scan& current, const Pose2& T_ref_cur)
{
  if (!isWellFormed(reference) || !isWellFormed(current)) return 0;
  const Eigen::Matrix2d R = T_ref_cur.rotation();
  const Eigen::Vector2d t_m = T_ref_cur.translation();
  int returns = 0, seen = 0;
  for (int ray = 0; ray < current.grid.count(); ray += kStride)
  {
    if (!isReturn(current, ray)) continue;
    const double range_m = current.range_m[static_cast<std::size_t>(ray)];
    ++returns;
    seen += isSeen(reference, R * (range_m * current.grid.direction(ray)) + t_m) ? 1 : 0;
  }
  return returns > 0 ? static_cast<double>(seen) / returns : 0;
}
}  // namespace psmks
