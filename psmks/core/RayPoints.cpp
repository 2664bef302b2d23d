/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/core/RayPoints.h>

namespace psmks
{
void RayPoints::build(const SegmentedScan& scan, const std::vector<std::uint8_t>& movableRays)
{
  const auto rays = static_cast<std::size_t>(scan.rays());
  x_m.resize(rays), y_m.resize(rays), movable.resize(rays);
  std::size_t n = 0;
  for (std::size_t i = 0; i < rays; ++i)
  {
    // Written in any case, kept only where valid.
    x_m[n] = static_cast<float>(scan.range_m[i] * scan.grid.cosines()[i]);
    y_m[n] = static_cast<float>(scan.range_m[i] * scan.grid.sines()[i]);
    movable[n] = movableRays.empty() ? std::uint8_t{0} : movableRays[i];
    n += scan.valid[i] != 0;
  }
  x_m.resize(n), y_m.resize(n), movable.resize(n);
}
}  // namespace psmks
