/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/support/LogScan.h>
#include <docs/pictures/ExamplePair.h>
#include <mrpt/obs/stock_observations.h>
#include <psmks/logs/OpenLog.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace psmks
{
namespace
{
ExamplePair matched(const Scan& reference, const Scan& current, const Guess& guess)
{
  const Matcher matcher;
  MatcherWorkspace workspace;
  ExamplePair pair;
  pair.guess = guess;
  matcher.segment(reference, workspace, pair.reference);
  matcher.segment(current, workspace, pair.current);
  pair.result = matcher.match(pair.reference, pair.current, guess, workspace);
  return pair;
}

/** What a scanner sees between two endless walls, y = -1 m and y = 1 m of the frame of its pose. */
Scan corridorScan(const Pose2& T_corridor_sensor)
{
  constexpr double kHalfWidth_m = 1, kMaxRange_m = 8, kFieldOfView_deg = 180;
  constexpr int kRays = 361;
  Scan scan;
  scan.grid = BeamGrid::centered(degToRad(kFieldOfView_deg), kRays);
  scan.maxRange_m = kMaxRange_m;
  for (int i = 0; i < kRays; ++i)
  {
    const double slope = std::sin(T_corridor_sensor.phi_rad + scan.grid.bearing_rad(i));
    const double wall_m = std::copysign(kHalfWidth_m, slope) - T_corridor_sensor.y_m;
    const double range_m = slope == 0 ? kMaxRange_m : wall_m / slope;
    scan.range_m.push_back(range_m < kMaxRange_m ? range_m
                                                 : std::numeric_limits<double>::infinity());
  }
  return scan;
}
}  // namespace

ExamplePair stockPair()
{
  mrpt::obs::CObservation2DRangeScan reference, current;
  mrpt::obs::stock_observations::example2DRangeScan(reference, 0);
  mrpt::obs::stock_observations::example2DRangeScan(current, 1);
  ScanConverter converter;
  return matched(converter.convert(reference), converter.convert(current), {{0.8, 0, 0}, {}});
}

ExamplePair pairOfLog(const std::string& log, int reference, int current)
{
  const auto reader = openLog(log);
  ScanConverter converter;
  Scan referenceScan;
  LaserFrame frame;
  for (int i = 0; reader->next(frame); ++i)
  {
    if (i == reference) referenceScan = toLogScan(frame, converter, {}).scan;
    if (i == current) return matched(referenceScan, toLogScan(frame, converter, {}).scan, Guess());
  }
  throw std::runtime_error(log + ": has no scan " + std::to_string(current));
}

ExamplePair bareCorridorPair()
{
  const Pose2 reference{0, -0.1, 0}, current{0.4, 0.1, degToRad(5)};
  return matched(corridorScan(reference), corridorScan(current), Guess());
}

ChartSeries rayPoints(const std::string& name, const SegmentedScan& scan, const Pose2& T_ref_scan,
                      unsigned rgb)
{
  ChartSeries series{name, {}, ChartSeries::Style::Points, rgb};
  for (int ray = 0; ray < scan.rays(); ++ray)
    if (scan.isValid(ray)) series.points.push_back(T_ref_scan * scan.point_m(ray));
  return series;
}

ChartSeries segmentLines(const std::string& name, const SegmentedScan& scan,
                         const Pose2& T_ref_scan, unsigned rgb)
{
  std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> ends;
  for (const Segment& segment : scan.segments)
    ends.emplace_back(T_ref_scan * segment.firstEnd_m, T_ref_scan * segment.lastEnd_m);
  ChartSeries series = lineSegments(name, ends);
  series.style = ChartSeries::Style::Line;
  series.rgb = rgb;
  return series;
}

ChartSeries scannerMark(const std::string& name, const Pose2& T_ref_scanner, double length_m,
                        unsigned rgb)
{
  const double width_m = 0.7 * length_m;
  ChartSeries series{name, {}, ChartSeries::Style::Line, rgb};
  for (const Eigen::Vector2d& corner :
       {Eigen::Vector2d(0, -width_m / 2), Eigen::Vector2d(length_m, 0),
        Eigen::Vector2d(0, width_m / 2), Eigen::Vector2d(0, -width_m / 2)})
    series.points.push_back(T_ref_scanner * corner);
  return series;
}

Chart planChart(const std::string& title)
{
  Chart chart;
  chart.title = title;
  chart.xLabel = "x, m";
  chart.yLabel = "y, m";
  chart.equalAspect = true;
  return chart;
}
}  // namespace psmks
