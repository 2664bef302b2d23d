/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/core/PolarSurface.h>

#include <algorithm>

namespace psmks
{
namespace
{
bool flagged(const std::vector<std::uint8_t>& flags, int ray)
{
  return !flags.empty() && flags[static_cast<std::size_t>(ray)] != 0;
}

/** Side 0 or 1 of a cell: the line of the ray's segment, else the tangent of the circle through its
 * end point. */
void setSide(PolarSurface::Cell& cell, int side, const SegmentedScan& scan, int ray,
             const std::vector<Eigen::Vector2d>& normals)
{
  const auto i = static_cast<std::size_t>(ray);
  const int s = scan.segmentOfRay[i];
  const bool onLine = s != SegmentedScan::kNoSegment;
  const Eigen::Vector2d n =
      onLine ? normals[static_cast<std::size_t>(s)] : scan.grid.direction(ray);
  cell.nx[side] = static_cast<float>(n.x());
  cell.ny[side] = static_cast<float>(n.y());
  cell.d[side] = static_cast<float>(onLine ? scan.segments[static_cast<std::size_t>(s)].line.r0_m
                                           : scan.range_m[i]);
  cell.segment[side] = s;
}
}  // namespace

void PolarSurface::build(const SegmentedScan& scan, const std::vector<std::uint8_t>& movableRays)
{
  const int rays = scan.rays();
  closed_ = scan.grid.closed();
  cells_ = closed_ ? rays : std::max(0, rays - 1);
  centreIndex_ = 0.5f * static_cast<float>(closed_ ? rays : rays - 1);
  centre_rad_ = static_cast<float>(
      wrapAngle(scan.grid.firstBearing_rad() + centreIndex_ * scan.grid.increment_rad()));
  raysPerRadian_ = static_cast<float>(1 / scan.grid.increment_rad());

  normals_.clear();
  for (const Segment& segment : scan.segments) normals_.push_back(segment.line.normal());
  storage_.resize(static_cast<std::size_t>(cells_));
  for (int k = 0; k < cells_; ++k)
  {
    Cell& cell = storage_[static_cast<std::size_t>(k)];
    const int next = k + 1 == rays ? 0 : k + 1;
    cell.known = scan.isValid(k) && scan.isValid(next);
    cell.movable = flagged(movableRays, k) && flagged(movableRays, next);
    setSide(cell, 0, scan, k, normals_);
    setSide(cell, 1, scan, next, normals_);
  }
}
}  // namespace psmks
