/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/psm/PsmProjection.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace psmks
{
namespace
{
/** A point in the polar coordinates of the reference frame. */
struct PolarPoint
{
  double range_m = 0, bearing_rad = 0;
};

PolarPoint polar(const Eigen::Vector2d& p) { return {p.norm(), std::atan2(p.y(), p.x())}; }

class Drawing
{
 public:
  Drawing(const BeamGrid& grid, PsmProjection& result) : grid_(grid), result_(result)
  {
    const auto rays = static_cast<std::size_t>(grid.count());
    result.range_m.assign(rays, std::numeric_limits<double>::infinity());
    result.tag.assign(rays, PsmTag::Empty);
  }

  void drawEdge(const PolarPoint& a, const PolarPoint& b)
  {
    const double turn_rad = wrapAngle(b.bearing_rad - a.bearing_rad);
    const double from = grid_.index(a.bearing_rad);
    const double rays = turn_rad / grid_.increment_rad();
    const PsmTag tag = turn_rad > 0 ? PsmTag::Good : PsmTag::Occluded;
    const auto first = static_cast<int>(std::ceil(std::min(from, from + rays) - kRounding));
    const auto last = static_cast<int>(std::floor(std::max(from, from + rays) + kRounding));
    for (int k = first; k <= last; ++k)
    {
      const double share = rays == 0 ? 0 : std::clamp((k - from) / rays, 0.0, 1.0);
      const int ray = grid_.neighbour(0, k);
      if (ray >= 0) draw(ray, a.range_m + share * (b.range_m - a.range_m), tag);
    }
  }

 private:
  /** A point that is this share of an increment beside a ray belongs to the ray. Unit: rays.
   * Definition: the rounding of bearings. */
  static constexpr double kRounding = 1e-9;

  void draw(int ray, double range_m, PsmTag tag)
  {
    const auto i = static_cast<std::size_t>(ray);
    if (range_m >= result_.range_m[i]) return;
    result_.range_m[i] = range_m;
    result_.tag[i] = tag;
  }

  const BeamGrid& grid_;
  PsmProjection& result_;
};
}  // namespace

void projectPsmScan(const PsmScan& current, const Pose2& T_ref_cur, const BeamGrid& referenceGrid,
                    PsmProjection& result)
{
  Drawing drawing(referenceGrid, result);
  const Eigen::Matrix2d rotation = T_ref_cur.rotation();
  const Eigen::Vector2d translation = T_ref_cur.translation();
  const auto projected = [&](int i)
  { return polar(Eigen::Vector2d(rotation * current.point(i) + translation)); };

  int before = current.grid.neighbour(0, -1);
  PolarPoint pointBefore;
  if (before >= 0 && current.segmentOf(before) != PsmScan::kNoSurface)
    pointBefore = projected(before);
  for (int i = 0; i < current.rays(); before = i++)
  {
    if (current.segmentOf(i) == PsmScan::kNoSurface) continue;
    const PolarPoint point = projected(i);
    if (before >= 0 && current.sameSurface(before, i)) drawing.drawEdge(pointBefore, point);
    pointBefore = point;
  }
}
}  // namespace psmks
