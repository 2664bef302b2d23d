/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/geometry/FastBearing.h>
#include <psmks/slam/Overlap.h>

#include <cmath>

namespace psmks
{
Overlap::Overlap(const Scan& reference, const Scan& current, int stride) : reference_(reference)
{
  if (!isWellFormed(reference) || !isWellFormed(current)) return;
  for (int ray = 0; ray < current.grid.count(); ray += stride)
    if (isReturn(current, ray))
      returns_m_.emplace_back(current.range_m[static_cast<std::size_t>(ray)] *
                              current.grid.direction(ray));
}

double Overlap::at(const Pose2& T_ref_cur) const
{
  if (returns_m_.empty()) return 0;
  const Eigen::Matrix2d R = T_ref_cur.rotation();
  const Eigen::Vector2d t_m = T_ref_cur.translation();
  std::size_t seen = 0;
  for (const Eigen::Vector2d& p_m : returns_m_) seen += isSeen(R * p_m + t_m) ? 1 : 0;
  return static_cast<double>(seen) / static_cast<double>(returns_m_.size());
}

bool Overlap::isSeen(const Eigen::Vector2d& point_m) const
{
  /** How far a return may lie from what the reference saw, because the pose is a guess. Evidence:
   * measured. */
  constexpr double kTolerance_m = 0.3;

  /** What every metre of the range adds to that, because a wrong heading moves a far return more.
   * Unit: m/m. Evidence: measured. */
  constexpr double kTolerancePerMetre = 0.05;
  const BeamGrid& grid = reference_.grid;
  const double range_m = point_m.norm();
  const double index =
      grid.index(fastBearing_rad(static_cast<float>(point_m.y()), static_cast<float>(point_m.x())));
  const bool isInside = index >= -0.5 && index <= grid.count() - 0.5;
  if (!isInside && !grid.closed()) return false;
  const double tolerance_m = kTolerance_m + kTolerancePerMetre * range_m;
  for (const int step : {0, 1})
  {
    const int ray = grid.neighbour(static_cast<int>(std::floor(index)), step);
    if (ray >= 0 && isReturn(reference_, ray) &&
        std::abs(reference_.range_m[static_cast<std::size_t>(ray)] - range_m) < tolerance_m)
      return true;
  }
  return false;
}

double overlap(const Scan& reference, const Scan& current, const Pose2& T_ref_cur)
{
  /** Every so many rays of a scan are looked up. Unit: rays. Evidence: measured. */
  constexpr int kStride = 4;
  return Overlap(reference, current, kStride).at(T_ref_cur);
}
}  // namespace psmks
