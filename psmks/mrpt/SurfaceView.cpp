/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/mrpt/SurfaceView.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
/** Neighbouring rays meet a wall whose normal is turned by an angle a against them at points that
 *  are 1/cos(a) times the spacing of the rays apart: three times at 70 degrees. */
constexpr double kSlantSpacing = 3;

double bearing_rad(const Eigen::Vector2d& p) { return std::atan2(p.y(), p.x()); }

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}
}  // namespace

SurfaceView::SurfaceView(const BeamGrid& grid, double maxGap_m) : grid_(grid), maxGap_m_(maxGap_m)
{
}

void SurfaceView::addPoint(const Eigen::Vector2d& p)
{
  const double range_m = p.norm();
  if (!std::isfinite(range_m) || range_m == 0) return;
  const int ray = static_cast<int>(std::lround(grid_.index(bearing_rad(p))));
  if (ray >= 0 && ray < grid_.count()) points_.push_back({p, range_m, ray});
}

std::vector<SurfaceView::Surface> SurfaceView::visibleSurfaces() const
{
  std::vector<Surface> surfaces(static_cast<std::size_t>(grid_.count()));
  const auto surfaceOf = [&](const Point& point) -> Surface&
  { return surfaces[static_cast<std::size_t>(point.ray)]; };

  for (const Point& point : points_)
    surfaceOf(point).nearest_m = std::min(surfaceOf(point).nearest_m, point.range_m);
  for (const Point& point : points_)
  {
    Surface& surface = surfaceOf(point);
    if (point.range_m > surface.nearest_m + maxGap_m_) continue;
    surface.sum += point.p;
    ++surface.points;
  }
  return surfaces;
}

double SurfaceView::reach_m(double range_m) const
{
  return maxGap_m_ + kSlantSpacing * range_m * grid_.increment_rad();
}

/** The next ray, counter-clockwise, whose surface continues that of a ray; -1 if none does. */
int SurfaceView::nextOnSurface(const std::vector<Surface>& surfaces, int ray) const
{
  const Eigen::Vector2d here = surfaces[static_cast<std::size_t>(ray)].mean();
  const double range_m = here.norm();
  const double reach = reach_m(range_m);
  const double reach_rad = reach < range_m ? std::asin(reach / range_m) : kPi / 2;
  for (int step = 1; (step - 1) * grid_.increment_rad() <= reach_rad; ++step)
  {
    const int next = grid_.neighbour(ray, step);
    if (next < 0) return -1;
    const Surface& surface = surfaces[static_cast<std::size_t>(next)];
    if (surface.points > 0 && (surface.mean() - here).norm() <= reach) return next;
  }
  return -1;
}

void SurfaceView::join(const Eigen::Vector2d& from, const Eigen::Vector2d& to, Scan& scan) const
{
  const double first = grid_.index(bearing_rad(from));
  double last = grid_.index(bearing_rad(to));
  if (last < first) last += grid_.count();  // across the seam of a closed grid

  const Eigen::Vector2d along = to - from;
  for (int k = static_cast<int>(std::ceil(first)); k <= last; ++k)
  {
    // The ray r u meets the join where from + s along = r u. The cross product with `along` removes
    // s and leaves r.
    const int ray = k % grid_.count();
    const double range_m = cross(from, along) / cross(grid_.direction(ray), along);
    const auto i = static_cast<std::size_t>(ray);
    if (!(range_m > 0) || !std::isfinite(range_m)) continue;
    if (scan.valid[i] && scan.range_m[i] <= range_m) continue;
    scan.range_m[i] = range_m;
    scan.valid[i] = 1;
  }
}

void SurfaceView::draw(Scan& scan) const
{
  const std::vector<Surface> surfaces = visibleSurfaces();
  for (int ray = 0; ray < grid_.count(); ++ray)
  {
    if (surfaces[static_cast<std::size_t>(ray)].points == 0) continue;
    const int next = nextOnSurface(surfaces, ray);
    if (next >= 0)
      join(surfaces[static_cast<std::size_t>(ray)].mean(),
           surfaces[static_cast<std::size_t>(next)].mean(), scan);
  }
}
}  // namespace psmks
