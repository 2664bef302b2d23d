/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/report/ScanOutline.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
constexpr double kCentimetresPerMetre = 100;

// Neighbouring points are joined if their distance is less than the larger of this gap and a
// multiple of the spacing of the rays: on a wall seen at an angle they are farther apart than the
// rays.
constexpr double kJoinedGap_m = 0.2;
constexpr double kJoinedFans = 4;

bool returned(const Scan& scan, std::size_t ray)
{
  const double range_m = scan.range_m[ray];
  return std::isfinite(range_m) && range_m > 0 &&
         (scan.maxRange_m == 0 || range_m < scan.maxRange_m) &&
         (scan.valid.empty() || scan.valid[ray] != 0);
}

Eigen::Vector2d pointOf(const Scan& scan, std::size_t ray)
{
  return scan.range_m[ray] * scan.grid.direction(static_cast<int>(ray));
}

bool joinsTheOneBefore(const Scan& scan, std::size_t ray)
{
  if (ray == 0 || !returned(scan, ray - 1)) return false;
  const double fan_m = scan.range_m[ray] * scan.grid.increment_rad();
  return (pointOf(scan, ray) - pointOf(scan, ray - 1)).norm() <
         std::max(kJoinedGap_m, kJoinedFans * fan_m);
}

Eigen::Vector2i pixel(const Eigen::Vector2d& p_m)
{
  return {static_cast<int>(std::lround(kCentimetresPerMetre * p_m.x())),
          static_cast<int>(std::lround(-kCentimetresPerMetre * p_m.y()))};
}

std::string relative(const Eigen::Vector2i& step)
{
  return std::to_string(step.x()) + (step.y() < 0 ? "" : " ") + std::to_string(step.y());
}
}  // namespace

std::vector<Eigen::Vector2d> returnPoints(const Scan& scan)
{
  std::vector<Eigen::Vector2d> points;
  for (std::size_t ray = 0; ray < scan.range_m.size(); ++ray)
    if (returned(scan, ray)) points.push_back(pointOf(scan, ray));
  return points;
}

std::string outlinePath(const Scan& scan)
{
  std::string path = "M0 0";
  Eigen::Vector2i pen(0, 0);
  for (std::size_t ray = 0; ray < scan.range_m.size(); ++ray)
  {
    if (!returned(scan, ray)) continue;
    const Eigen::Vector2i next = pixel(pointOf(scan, ray));
    // A stroke of length 0 draws a dot, for a point that is not joined to others.
    path += joinsTheOneBefore(scan, ray) ? 'l' + relative(next - pen)
                                         : 'm' + relative(next - pen) + "h0";
    pen = next;
  }
  return path;
}
}  // namespace psmks
