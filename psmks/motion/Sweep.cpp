/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/motion/Sweep.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
/** So many rays of this increment fit into a circle. */
int raysOfCircle(double increment_rad)
{
  return static_cast<int>(std::floor(2 * kPi / increment_rad + 0.5));
}

void dropRaysFrom(int first, Scan& scan)
{
  const auto rays = static_cast<std::size_t>(first);
  scan.range_m.resize(rays);
  if (!scan.valid.empty()) scan.valid.resize(rays);
}
}  // namespace

void straightenSweep(Scan& scan, double turnRate_rad_s)
{
  const int rays = scan.grid.count();
  const double turned_rad = turnRate_rad_s * scan.sweepDuration_s;
  if (rays < 2 || turned_rad == 0 || !std::isfinite(turned_rad)) return;
  if (scan.range_m.size() != static_cast<std::size_t>(rays)) return;
  const double increment_rad = scan.grid.increment_rad() + turned_rad / (rays - 1);
  if (increment_rad < BeamGrid::kLeastIncrement_rad) return;

  const int kept = std::min(rays, raysOfCircle(increment_rad));
  scan.grid = BeamGrid(scan.grid.firstBearing_rad(), increment_rad, kept);
  if (kept < rays) dropRaysFrom(kept, scan);
}

double sweepDuration_s(const BeamGrid& grid, double beamTurn_s)
{
  const double swept_rad = std::max(0, grid.count() - 1) * grid.increment_rad();
  return beamTurn_s * swept_rad / (2 * kPi);
}

void TurnRate::add(double stamp_s, double turned_rad)
{
  if (!std::isfinite(stamp_s) || !std::isfinite(turned_rad)) return readings_.clear();
  const double heading_rad = readings_.empty() ? 0 : readings_.back().heading_rad + turned_rad;
  if (!readings_.empty() && stamp_s < readings_.back().stamp_s) readings_.clear();
  readings_.push_back({stamp_s, heading_rad});
  while (readings_.size() > 2 && stamp_s - readings_[1].stamp_s >= kWindow_s) readings_.pop_front();
}

double TurnRate::rate_rad_s() const
{
  if (readings_.size() < 2) return 0;
  const Reading &first = readings_.front(), &last = readings_.back();
  const double time_s = last.stamp_s - first.stamp_s;
  if (!(time_s >= kWindow_s / 4) || time_s > kMaxAge_s) return 0;
  return (last.heading_rad - first.heading_rad) / time_s;
}
}  // namespace psmks
