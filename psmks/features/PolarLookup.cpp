/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/features/PolarLookup.h>

#include <algorithm>

namespace psmks
{
void PolarLookup::build(const SegmentedScan& scan, const std::vector<AnchoredLine>& lines,
                        const std::vector<int>& lineOfRay,
                        const std::vector<std::uint8_t>& hasSurface,
                        const std::vector<std::uint8_t>& movableRays)
{
  const int rays = scan.rays();
  closed_ = scan.grid.closed();
  cells_ = closed_ ? rays : std::max(0, rays - 1);
  centreIndex_ = 0.5f * static_cast<float>(closed_ ? rays : rays - 1);
  centre_rad_ = static_cast<float>(
      wrapAngle(scan.grid.firstBearing_rad() + centreIndex_ * scan.grid.increment_rad()));
  raysPerRadian_ = static_cast<float>(1 / scan.grid.increment_rad());

  lineSides_.resize(lines.size());
  for (std::size_t l = 0; l < lines.size(); ++l)
    lineSides_[l] = {static_cast<float>(lines[l].normal.x()),
                     static_cast<float>(lines[l].normal.y()),
                     static_cast<float>(lines[l].distance_m), static_cast<int>(l)};

  const auto size = static_cast<std::size_t>(rays);
  sides_.resize(size + 1);
  Side* side = sides_.data();
  const Side* ofLine = lineSides_.data();
  for (std::size_t i = 0; i < size; ++i)
    side[i] = lineOfRay[i] >= 0 ? ofLine[lineOfRay[i]] : roundSide(scan, i);
  sides_[size] = sides_[0];
  flagCells(hasSurface, movableRays);
}

/** The surface of a ray without a line: the tangent, at the end point of the ray, of the circle
 * about the scanner. */
PolarLookup::Side PolarLookup::roundSide(const SegmentedScan& scan, std::size_t ray)
{
  return {static_cast<float>(scan.grid.cosines()[ray]), static_cast<float>(scan.grid.sines()[ray]),
          static_cast<float>(scan.range_m[ray]), -1};
}

/** Sets the flags of each cell to those that both of its rays have. */
void PolarLookup::flagCells(const std::vector<std::uint8_t>& hasSurface,
                            const std::vector<std::uint8_t>& movable)
{
  const std::size_t rays = hasSurface.size();
  flags_.resize(rays + 1);
  const std::uint8_t *known = hasSurface.data(), *moves = movable.data();
  std::uint8_t* flag = flags_.data();
  for (std::size_t i = 0; i < rays; ++i)
    flag[i] = static_cast<std::uint8_t>((known[i] != 0) * kKnown | (moves[i] != 0) * kMovable);
  flag[rays] = flag[0];
  for (std::size_t k = 0; k < rays; ++k) flag[k] &= flag[k + 1];
}
}  // namespace psmks
