/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/core/FreeSpaceScore.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
RayCounts countRays(const RayPoints& points, const PolarSurface& surface,
                    const Pose2& T_surface_points, float tolerance_m, int stride)
{
  const auto c = static_cast<float>(std::cos(T_surface_points.phi_rad));
  const auto s = static_cast<float>(std::sin(T_surface_points.phi_rad));
  const auto tx = static_cast<float>(T_surface_points.x_m);
  const auto ty = static_cast<float>(T_surface_points.y_m);
  RayCounts counts;
  const auto n = static_cast<std::size_t>(points.size());
  for (std::size_t i = 0; i < n; i += static_cast<std::size_t>(stride))
  {
    const float x = c * points.x_m[i] - s * points.y_m[i] + tx;
    const float y = s * points.x_m[i] + c * points.y_m[i] + ty;
    const int k = surface.cellOf(x, y);
    if (k < 0 || !surface.cell(k).known)
    {
      ++counts.unknown;
      continue;
    }
    const PolarSurface::Cell& cell = surface.cell(k);
    const float a = cell.nx[0] * x + cell.ny[0] * y - cell.d[0];
    const float b = cell.nx[1] * x + cell.ny[1] * y - cell.d[1];
    const float nearest = std::min(std::fabs(a), std::fabs(b));
    const float low = std::min(a, b), high = std::max(a, b);
    // Between the near and the far side of a jump anything may stand: such a ray says nothing.
    const bool on = nearest < tolerance_m, front = high<0, behind = low> 0;
    counts.on += on;
    const bool movable = points.movable[i] != 0;
    counts.front += !on && front && !movable;
    counts.moved += !on && front && movable;
    counts.behind += !on && behind && !cell.movable;
    counts.uncovered += !on && behind && cell.movable;
  }
  return counts;
}

double freeSpaceScore(const RayCounts& n)
{
  constexpr double kFullyVisible = 0.4;
  const double decided = n.on + n.front + 0.5 * (n.behind + n.moved) + 0.25 * n.uncovered;
  const double seen = n.on + n.front + n.behind + n.moved + n.uncovered;
  if (!(decided > 0)) return 0;
  const double visibleShare = seen / (seen + n.unknown);
  return n.on / decided * std::min(1.0, visibleShare / kFullyVisible);
}

float surfaceTolerance_m(double rangeSigma_m)
{
  constexpr double kSmallest_m = 0.04, kMargin_m = 0.01;
  return static_cast<float>(std::max(kSmallest_m, 3 * rangeSigma_m + kMargin_m));
}
}  // namespace psmks
