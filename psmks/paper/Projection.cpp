/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/geometry/FastBearing.h>
#include <psmks/paper/Projection.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
/** Neighbouring single rays whose ranges differ by less lie on one surface. Evidence: the original
 * polar scan matching takes 20 cm in its segmentation. */
constexpr double kSurfaceStep_m = 0.20;

/** How much nearer a surface has to be to hide a point. The lines of two segments that meet in a
 * corner cross by a few centimetres. Evidence: measured. */
constexpr double kHidingMargin_m = 0.10;

/** Smallest range of a projected point. Definition: it keeps 1 / range finite where the reference
 * viewpoint stands on a point. */
constexpr double kLeastRange_m = 1e-3;

double denoisedRange_m(const SegmentedScan& scan, int ray)
{
  const double range_m = scan.denoisedRange_m(ray);
  return std::isfinite(range_m) ? range_m : scan.range_m[static_cast<std::size_t>(ray)];
}

bool onOneSurface(const SegmentedScan& scan, int before, int ray)
{
  const int segmentBefore = scan.segmentOfRay[static_cast<std::size_t>(before)];
  const int segment = scan.segmentOfRay[static_cast<std::size_t>(ray)];
  if (segmentBefore != segment) return false;
  if (segment != SegmentedScan::kNoSegment) return true;
  const double step_m =
      scan.range_m[static_cast<std::size_t>(ray)] - scan.range_m[static_cast<std::size_t>(before)];
  return std::abs(step_m) < kSurfaceStep_m;
}

void transformPoints(const DenoisedRays& rays, const Pose2& T, Projection& result)
{
  const double c = std::cos(T.phi_rad), s = std::sin(T.phi_rad);
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    const double x = c * rays.x_m[i] - s * rays.y_m[i] + T.x_m;
    const double y = s * rays.x_m[i] + c * rays.y_m[i] + T.y_m;
    result.x_m[i] = x;
    result.y_m[i] = y;
    result.range_m[i] = std::sqrt(x * x + y * y);
  }
}

void transformLines(const SegmentedScan& current, const Pose2& T, Projection& result)
{
  for (std::size_t k = 0; k < current.segments.size(); ++k)
  {
    bool turned = false;
    result.lines[k] = current.segments[k].line.transformed(T, &turned);
    result.lineTurned[k] = turned;
  }
}

/** The index finds neighbouring rays and nothing else; range values come from the lines, exactly.
 */
double indexOf(std::size_t i, const BeamGrid& grid, const Projection& p)
{
  const auto x = static_cast<float>(p.x_m[i]), y = static_cast<float>(p.y_m[i]);
  return grid.index(static_cast<double>(fastBearing_rad(y, x)));
}

/** A ray stands for half an increment on either side. */
bool isOutside(double index, const BeamGrid& grid)
{
  return !grid.closed() && (index < -0.5 || index > grid.count() - 0.5);
}

/** Steps of the bearing from one point to another, in reference rays, the short way round. */
double advance(const Projection& p, std::size_t before, std::size_t i, double circle)
{
  const double step = p.index[i] - p.index[before];
  return step > circle / 2 ? step - circle : (step < -circle / 2 ? step + circle : step);
}

/** Draws the surface between two points on the buffer. Along a straight wall 1 / range is a cosine
 * of the bearing, so that it may be interpolated linearly between neighbouring rays. */
void drawSurface(std::size_t before, std::size_t i, double step, int surface, const BeamGrid& grid,
                 Projection& p)
{
  const double from = p.index[before], low = from + std::min(0.0, step);
  const double high = from + std::max(0.0, step);
  const double nearBefore = 1 / std::max(kLeastRange_m, p.range_m[before]);
  const double nearNow = 1 / std::max(kLeastRange_m, p.range_m[i]);
  for (int k = static_cast<int>(std::ceil(low)); k <= high; ++k)
  {
    const int ray = grid.neighbour(k, 0);
    if (ray < 0) continue;
    const double share = step == 0 ? 0 : (k - from) / step;
    const double nearness_1pm = nearBefore + share * (nearNow - nearBefore);
    Projection::Nearest& nearest = p.nearest[static_cast<std::size_t>(ray)];
    if (nearness_1pm > nearest.nearness_1pm) nearest = {nearness_1pm, surface};
  }
}

/** Draws every surface, and marks the single points of those that turn their back. */
void drawSurfaces(const DenoisedRays& rays, const BeamGrid& grid, Projection& p)
{
  const double circle = 2 * kPi / grid.increment_rad();
  std::size_t before = rays.size() - 1;
  for (std::size_t i = 0; i < rays.size(); before = i++)
  {
    if (!rays.continuesSurface[i]) continue;
    const double step = advance(p, before, i, circle);
    drawSurface(before, i, step, rays.surface[i], grid, p);
    const bool single = rays.segment[i] == SegmentedScan::kNoSegment;
    if (single && step <= 0) p.mark[i] = RayMark::SeenFromBehind;
  }
}

/** True where one surface is nearer at the reference rays on both sides of the point's bearing. Two
 *  surfaces that meet in a corner between both rays do not hide it. */
bool isHidden(const Projection& p, std::size_t i, const BeamGrid& grid)
{
  if (p.range_m[i] <= kHidingMargin_m) return false;
  const int below = grid.neighbour(static_cast<int>(std::floor(p.index[i])), 0);
  const int above = grid.neighbour(static_cast<int>(std::ceil(p.index[i])), 0);
  if (below < 0 || above < 0) return false;
  const Projection::Nearest& a = p.nearest[static_cast<std::size_t>(below)];
  const Projection::Nearest& b = p.nearest[static_cast<std::size_t>(above)];
  const double hiding_1pm = 1 / (p.range_m[i] - kHidingMargin_m);
  return a.surface == b.surface && std::min(a.nearness_1pm, b.nearness_1pm) > hiding_1pm;
}

RayMark markOf(const DenoisedRays& rays, std::size_t i, const SegmentedScan& reference,
               const Projection& p)
{
  const BeamGrid& grid = reference.grid;
  if (isOutside(p.index[i], grid)) return RayMark::OutsideView;
  if (reference.maxRange_m > 0 && p.range_m[i] >= reference.maxRange_m) return RayMark::BeyondRange;
  const int segment = rays.segment[i];
  const bool turned = segment == SegmentedScan::kNoSegment
                          ? p.mark[i] == RayMark::SeenFromBehind
                          : p.lineTurned[static_cast<std::size_t>(segment)] != 0;
  if (turned) return RayMark::SeenFromBehind;
  return isHidden(p, i, grid) ? RayMark::Hidden : RayMark::Visible;
}

void resize(Projection& p, std::size_t rays, std::size_t segments, std::size_t referenceRays)
{
  p.x_m.resize(rays);
  p.y_m.resize(rays);
  p.range_m.resize(rays);
  p.index.resize(rays);
  p.mark.assign(rays, RayMark::Visible);
  p.lines.resize(segments);
  p.lineTurned.resize(segments);
  p.nearest.assign(referenceRays, {});
}
}  // namespace

void DenoisedRays::assign(const SegmentedScan& scan)
{
  ray.clear();
  segment.clear();
  x_m.clear();
  y_m.clear();
  for (int i = 0; i < scan.rays(); ++i)
  {
    if (!scan.isValid(i)) continue;
    const double range_m = psmks::denoisedRange_m(scan, i);
    ray.push_back(i);
    segment.push_back(scan.segmentOfRay[static_cast<std::size_t>(i)]);
    x_m.push_back(range_m * scan.grid.cosines()[i]);
    y_m.push_back(range_m * scan.grid.sines()[i]);
  }
  joinSurfaces(scan);
}

void DenoisedRays::joinSurfaces(const SegmentedScan& scan)
{
  continuesSurface.clear();
  surface.clear();
  if (ray.empty()) return;
  int before = ray.back(), count = 0;
  for (const int i : ray)
  {
    const bool neighbours = scan.grid.neighbour(i, -1) == before;
    continuesSurface.push_back(neighbours && onOneSurface(scan, before, i));
    if (!continuesSurface.back()) ++count;
    surface.push_back(count);
    before = i;
  }
  // On a closed scan the first rays may continue the surface of the last ones.
  if (continuesSurface.front()) std::replace(surface.begin(), surface.end(), count, 0);
}

void projectScan(const DenoisedRays& rays, const SegmentedScan& current, const Pose2& T_ref_cur,
                 const SegmentedScan& reference, Projection& result)
{
  resize(result, rays.size(), current.segments.size(), static_cast<std::size_t>(reference.rays()));
  if (rays.size() == 0) return;

  transformLines(current, T_ref_cur, result);
  transformPoints(rays, T_ref_cur, result);
  for (std::size_t i = 0; i < rays.size(); ++i)
    result.index[i] = indexOf(i, reference.grid, result);

  drawSurfaces(rays, reference.grid, result);
  for (std::size_t i = 0; i < rays.size(); ++i) result.mark[i] = markOf(rays, i, reference, result);
}
}  // namespace psmks
