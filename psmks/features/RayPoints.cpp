/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/features/RayPoints.h>

#include <algorithm>

namespace psmks
{
void RayPoints::build(const SegmentedScan& scan, const std::vector<std::uint8_t>& movableRays)
{
  const auto rays = static_cast<std::size_t>(scan.rays());
  x_m.resize(rays), y_m.resize(rays), looks.resize(rays);
  movable = movableRays;
  movable.resize(rays, 0);
  const double *range_m = scan.range_m.data(), *cosines = scan.grid.cosines(),
               *sines = scan.grid.sines();
  float *x = x_m.data(), *y = y_m.data(), *look = looks.data();
  const auto looksPerMetre =
      static_cast<float>(scan.grid.increment_rad() * scan.returnSpacing) / kLook_m;
  for (std::size_t i = 0; i < rays; ++i)
  {
    x[i] = static_cast<float>(range_m[i] * cosines[i]);
    y[i] = static_cast<float>(range_m[i] * sines[i]);
    look[i] = std::min(1.0f, static_cast<float>(range_m[i]) * looksPerMetre);
  }
  keepValid(scan.valid);
}

/** Drops the points of invalid rays, and closes the gaps. */
void RayPoints::keepValid(const std::vector<std::uint8_t>& valid)
{
  std::size_t n = 0;
  while (n < valid.size() && valid[n]) ++n;
  for (std::size_t i = n; i < valid.size(); ++i)
  {
    if (!valid[i]) continue;
    x_m[n] = x_m[i], y_m[n] = y_m[i], movable[n] = movable[i], looks[n] = looks[i];
    ++n;
  }
  x_m.resize(n), y_m.resize(n), movable.resize(n), looks.resize(n);
}
}  // namespace psmks
