/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/core/PolarSurface.h>

#include <algorithm>

namespace psmks
{
namespace
{
/** Side 0 or 1 of a cell: the line of the ray, else the tangent of the circle through its end
 * point. */
void setSide(PolarSurface::Cell& cell, int side, const SegmentedScan& scan, int ray,
             const std::vector<AnchoredLine>& lines, const std::vector<int>& lineOfRay)
{
  const auto i = static_cast<std::size_t>(ray);
  const int line = lineOfRay[i];
  const AnchoredLine* l = line < 0 ? nullptr : &lines[static_cast<std::size_t>(line)];
  cell.nx[side] = static_cast<float>(l ? l->normal.x() : scan.grid.cosines()[i]);
  cell.ny[side] = static_cast<float>(l ? l->normal.y() : scan.grid.sines()[i]);
  cell.d[side] = static_cast<float>(l ? l->distance_m : scan.range_m[i]);
  cell.line[side] = line;
}
}  // namespace

void PolarSurface::build(const SegmentedScan& scan, const std::vector<AnchoredLine>& lines,
                         const std::vector<int>& lineOfRay,
                         const std::vector<std::uint8_t>& movableRays)
{
  const int rays = scan.rays();
  closed_ = scan.grid.closed();
  cells_ = closed_ ? rays : std::max(0, rays - 1);
  centreIndex_ = 0.5f * static_cast<float>(closed_ ? rays : rays - 1);
  centre_rad_ = static_cast<float>(
      wrapAngle(scan.grid.firstBearing_rad() + centreIndex_ * scan.grid.increment_rad()));
  raysPerRadian_ = static_cast<float>(1 / scan.grid.increment_rad());

  storage_.resize(static_cast<std::size_t>(cells_));
  for (int k = 0; k < cells_; ++k)
  {
    Cell& cell = storage_[static_cast<std::size_t>(k)];
    const int next = k + 1 == rays ? 0 : k + 1;
    cell.known = scan.isValid(k) && scan.isValid(next);
    cell.movable =
        movableRays[static_cast<std::size_t>(k)] && movableRays[static_cast<std::size_t>(next)];
    setSide(cell, 0, scan, k, lines, lineOfRay);
    setSide(cell, 1, scan, next, lines, lineOfRay);
  }
}
}  // namespace psmks
