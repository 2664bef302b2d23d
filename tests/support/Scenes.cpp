/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <tests/support/Scenes.h>

#include <Eigen/LU>
#include <limits>

namespace psmks
{
namespace
{
constexpr int kMinRays = 6;
constexpr double kNominalSigma_m = 0.01;

struct Hit
{
  double range_m = std::numeric_limits<double>::infinity();
  int wall = -1;
};

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/** Solves origin + range * direction = a + share * (b - a). */
double rangeTo_m(const Wall& wall, const Eigen::Vector2d& origin, const Eigen::Vector2d& direction)
{
  const Eigen::Vector2d along = wall.b - wall.a, toStart = wall.a - origin;
  const double determinant = cross(direction, along);
  const double range_m = cross(toStart, along) / determinant;
  const double share = cross(toStart, direction) / determinant;
  const bool meets = range_m > 0 && share >= 0 && share <= 1;
  return meets ? range_m : std::numeric_limits<double>::infinity();
}

Hit nearestHit(const std::vector<Wall>& walls, const Pose2& T_world_sensor, double bearing_rad)
{
  const double heading_rad = T_world_sensor.phi_rad + bearing_rad;
  const Eigen::Vector2d direction(std::cos(heading_rad), std::sin(heading_rad));
  Hit nearest;
  for (std::size_t w = 0; w < walls.size(); ++w)
  {
    const double range_m = rangeTo_m(walls[w], T_world_sensor.translation(), direction);
    if (range_m < nearest.range_m) nearest = {range_m, static_cast<int>(w)};
  }
  return nearest;
}

/** The line of a wall in the sensor frame. */
Line lineOf(const Wall& wall, const Pose2& T_world_sensor)
{
  const Pose2 T_sensor_world = T_world_sensor.inverse();
  const Eigen::Vector2d a = T_sensor_world * wall.a;
  const Eigen::Vector2d along = (T_sensor_world * wall.b - a).normalized();
  const Eigen::Vector2d normal(along.y(), -along.x());
  return Line::fromNormalForm(normal.dot(a), std::atan2(normal.y(), normal.x()),
                              Eigen::Matrix2d::Zero());
}

/** Fits a line to ranges by Gauss-Newton with h = r0 / cos(b - phi0), starting from the true line.
 */
Line fitted(Line line, const std::vector<int>& rays, const Scan& scan, double sigma_m)
{
  constexpr int kSteps = 4;
  for (int step = 0; step < kSteps; ++step)
  {
    Eigen::Matrix2d A = Eigen::Matrix2d::Zero();
    Eigen::Vector2d g = Eigen::Vector2d::Zero();
    for (const int i : rays)
    {
      const double angle_rad = scan.grid.bearing_rad(i) - line.phi0_rad;
      const double c = std::cos(angle_rad), s = std::sin(angle_rad);
      const Eigen::Vector2d h(1 / c, -line.r0_m * s / (c * c));
      A += h * h.transpose();
      g += h * (scan.range_m[static_cast<std::size_t>(i)] - line.r0_m / c);
    }
    const Eigen::Matrix2d inverse = A.inverse();
    const Eigen::Vector2d d = inverse * g;
    line =
        Line::fromNormalForm(line.r0_m + d[0], line.phi0_rad + d[1], sigma_m * sigma_m * inverse);
  }
  return line;
}

/** Runs of consecutive rays on the same wall. On a closed scan a run may pass from the last ray to
 * the first. */
std::vector<std::vector<int>> runsOf(const std::vector<int>& wallOfRay, const BeamGrid& grid)
{
  const auto wallOf = [&](int i) { return wallOfRay[static_cast<std::size_t>(i)]; };
  const auto startsRun = [&](int i)
  {
    const int before = grid.neighbour(i, -1);
    return wallOf(i) >= 0 && (before < 0 || wallOf(before) != wallOf(i));
  };
  std::vector<std::vector<int>> runs;
  for (int first = 0; first < grid.count(); ++first)
  {
    if (!startsRun(first)) continue;
    std::vector<int> run;
    for (int i = first; i >= 0 && wallOf(i) == wallOf(first); i = grid.neighbour(i, 1))
      run.push_back(i);
    runs.push_back(run);
  }
  return runs;
}

Segment segmentOf(const std::vector<int>& run, const Line& line, const BeamGrid& grid,
                  double sigma_m)
{
  Segment segment;
  segment.line = line;
  segment.firstRay = run.front();
  segment.lastRay = run.back();
  segment.rays = static_cast<int>(run.size());
  segment.sigma_m = sigma_m;
  const auto onLine = [&](int i) -> Eigen::Vector2d
  { return line.rangeAt_m(grid.bearing_rad(i)) * grid.direction(i); };
  segment.firstEnd_m = onLine(segment.firstRay);
  segment.lastEnd_m = onLine(segment.lastRay);
  return segment;
}

SegmentedScan unsegmented(const Scan& scan, const std::vector<int>& wallOfRay)
{
  SegmentedScan result;
  result.grid = scan.grid;
  result.range_m = scan.range_m;
  for (std::size_t i = 0; i < wallOfRay.size(); ++i)
  {
    result.valid.push_back(wallOfRay[i] >= 0);
    if (wallOfRay[i] < 0) result.range_m[i] = 0;
  }
  result.maxRange_m = scan.maxRange_m;
  result.rangeNoise = {scan.rangeSigma_m};
  result.segmentOfRay.assign(wallOfRay.size(), SegmentedScan::kNoSegment);
  return result;
}

void append(std::vector<Wall>& walls, const std::vector<Wall>& more)
{
  walls.insert(walls.end(), more.begin(), more.end());
}
}  // namespace

std::vector<int> wallsSeen(const std::vector<Wall>& walls, const Pose2& T_world_sensor,
                           const BeamGrid& grid, double maxRange_m)
{
  std::vector<int> seen;
  for (int i = 0; i < grid.count(); ++i)
  {
    const Hit hit = nearestHit(walls, T_world_sensor, grid.bearing_rad(i));
    seen.push_back(hit.range_m < maxRange_m ? hit.wall : -1);
  }
  return seen;
}

Scan castScan(const std::vector<Wall>& walls, const Pose2& T_world_sensor, const BeamGrid& grid,
              double maxRange_m, double sigma_m, std::mt19937& rng)
{
  std::normal_distribution<double> unitNoise;
  Scan scan;
  scan.grid = grid;
  scan.maxRange_m = maxRange_m;
  scan.rangeSigma_m = sigma_m > 0 ? sigma_m : kNominalSigma_m;
  for (int i = 0; i < grid.count(); ++i)
  {
    const double range_m = nearestHit(walls, T_world_sensor, grid.bearing_rad(i)).range_m;
    scan.range_m.push_back(range_m < maxRange_m ? range_m + sigma_m * unitNoise(rng) : maxRange_m);
  }
  return scan;
}

Scan castScan(const std::vector<Wall>& walls, const Pose2& T_world_sensor, const BeamGrid& grid,
              double maxRange_m)
{
  std::mt19937 unused;
  return castScan(walls, T_world_sensor, grid, maxRange_m, 0, unused);
}

SegmentedScan segmentByWalls(const Scan& scan, const std::vector<Wall>& walls,
                             const Pose2& T_world_sensor)
{
  const std::vector<int> wallOfRay = wallsSeen(walls, T_world_sensor, scan.grid, scan.maxRange_m);
  SegmentedScan result = unsegmented(scan, wallOfRay);
  for (const std::vector<int>& run : runsOf(wallOfRay, scan.grid))
  {
    if (static_cast<int>(run.size()) < kMinRays) continue;
    const Wall& wall = walls[static_cast<std::size_t>(wallOfRay[static_cast<std::size_t>(run[0])])];
    const Line line = fitted(lineOf(wall, T_world_sensor), run, scan, scan.rangeSigma_m);
    for (const int i : run)
      result.segmentOfRay[static_cast<std::size_t>(i)] = static_cast<int>(result.segments.size());
    result.segments.push_back(segmentOf(run, line, scan.grid, scan.rangeSigma_m));
  }
  return result;
}

std::vector<Wall> outline(const std::vector<Eigen::Vector2d>& corners_m)
{
  std::vector<Wall> walls;
  for (std::size_t i = 0; i < corners_m.size(); ++i)
    walls.push_back({corners_m[i], corners_m[(i + 1) % corners_m.size()]});
  return walls;
}

std::vector<Wall> box(const Eigen::Vector2d& centre_m, double length_m, double width_m,
                      double phi_rad)
{
  const Pose2 T_world_box{centre_m.x(), centre_m.y(), phi_rad};
  const auto corner = [&](double x, double y) -> Eigen::Vector2d
  { return T_world_box * Eigen::Vector2d(x * length_m / 2, y * width_m / 2); };
  return outline({corner(1, 1), corner(-1, 1), corner(-1, -1), corner(1, -1)});
}

std::vector<Wall> squareRoom() { return box({0, 0}, 6, 6); }

std::vector<Wall> officeRoom()
{
  //  (-4,3) +-------------+ (1,3)
  //         |             +-------+ (4,2.2)
  //         |   [] pillar         |
  //         |         o           |
  //         |             // cupboard
  // (-4,-3) +---------------------+ (4,-3)
  std::vector<Wall> walls = outline({{1, 3}, {-4, 3}, {-4, -3}, {4, -3}, {4, 2.2}, {1, 2.2}});
  append(walls, box({-2.2, 1.3}, 0.5, 0.5));
  append(walls, box({2.3, -1.8}, 1.4, 0.6, degToRad(25)));
  return walls;
}

std::vector<Wall> corridor() { return {{{30, 1}, {-30, 1}}, {{-30, -1}, {30, -1}}}; }

std::vector<Wall> clutteredRoom(unsigned seed)
{
  constexpr int kBoxes = 8;
  std::mt19937 rng(seed);
  const auto between = [&rng](double low, double high)
  { return low + (high - low) * static_cast<double>(rng()) / 4294967296.0; };
  std::vector<Wall> walls = box({0, 0}, 10, 8);
  for (int i = 0; i < kBoxes; ++i)
  {
    const double distance_m = between(2.0, 3.6), around_rad = between(-kPi, kPi);
    const double length_m = between(0.4, 1.2), width_m = between(0.3, 0.8);
    append(walls, box({1.2 * distance_m * std::cos(around_rad), distance_m * std::sin(around_rad)},
                      length_m, width_m, between(-kPi, kPi)));
  }
  return walls;
}
}  // namespace psmks
