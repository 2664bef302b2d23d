/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/support/LogScan.h>
#include <docs/pictures/Pictures.h>
#include <psmks/logs/OpenLog.h>
#include <psmks/matchers/PairMatcher.h>
#include <psmks/motion/OdometryNoise.h>
#include <psmks/slam/ScanMap.h>
#include <psmks/slam/TrajectoryBuilder.h>

namespace psmks
{
namespace
{
std::vector<PosedScan> trajectoryOf(const std::string& log)
{
  TrajectoryBuilder builder(makePairMatcher("psmks"), ReferenceOptions(), OdometryOptions());
  const auto reader = openLog(log);
  ScanConverter converter;
  LaserFrame frame;
  while (reader->next(frame))
  {
    LogScan scan = toLogScan(frame, converter, {});
    builder.add(std::move(scan.scan), scan.T_robot_sensor, scan.odometry);
  }
  builder.optimise();
  return builder.scans();
}

/** Every fourth return of every scan: all of them would hide each other. */
ChartSeries returns(const std::vector<PosedScan>& scans)
{
  constexpr std::size_t kStride = 4;
  const std::vector<Eigen::Vector2d> points_m = makeScanMap(scans, MatcherOptions()).points_m;
  ChartSeries series{"ends of every fourth ray", {}, ChartSeries::Style::Points, kGrey};
  for (std::size_t i = 0; i < points_m.size(); i += kStride) series.points.push_back(points_m[i]);
  return series;
}

ChartSeries keyframes(const std::vector<PosedScan>& scans)
{
  ChartSeries series{"keyframes", {}, ChartSeries::Style::Points, kVermillion};
  for (const PosedScan& scan : scans)
    if (scan.isReference) series.points.push_back(scan.T_world_robot.pose.translation());
  return series;
}

ChartSeries links(const std::vector<PosedScan>& scans)
{
  std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> ends;
  for (const PosedScan& scan : scans)
    for (const auto* matches : {&scan.matches, &scan.links})
      for (const ReferenceMatch& match : *matches)
        if (scan.isReference && match.result.usable())
          ends.emplace_back(scan.T_world_robot.pose.translation(),
                            scans[match.reference].T_world_robot.pose.translation());
  ChartSeries series = lineSegments("links: matches between keyframes", ends);
  series.rgb = kBlue;
  series.style = ChartSeries::Style::ThinLine;
  return series;
}
}  // namespace

Figure mapFigure(const std::string& log)
{
  const std::vector<PosedScan> scans = trajectoryOf(log);
  Chart chart = planChart("Keyframes and the links between them");
  chart.xRange = {-32, 18};
  chart.yRange = {-28, 16};
  chart.series = {returns(scans), links(scans), keyframes(scans)};

  Figure figure;
  figure.columns = 1;
  figure.panelWidth_px = 1200;
  figure.panelHeight_px = 900;
  figure.panels = {chart};
  return figure;
}
}  // namespace psmks
