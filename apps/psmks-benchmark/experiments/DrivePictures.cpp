/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/experiments/DrivePictures.h>
#include <psmks/slam/ScanMap.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
constexpr double kCentimetre = 100;
constexpr unsigned kWallColour = 0xb0b0b0;
constexpr unsigned kTruthColour = 0x000000;
constexpr unsigned kMapColour = 0x203080;
constexpr unsigned kOdometryColour = 0x808080;  // one that no method has

using Ends = std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>>;
using ErrorOf = std::function<double(const Pose2& estimate, const Pose2& truth)>;

double positionError_cm(const Pose2& estimate, const Pose2& truth)
{
  return (estimate.translation() - truth.translation()).norm() * kCentimetre;
}

double headingError_deg(const Pose2& estimate, const Pose2& truth)
{
  return radToDeg(std::abs(wrapAngle(estimate.phi_rad - truth.phi_rad)));
}

std::vector<Pose2> truePoses(const Recording& recording)
{
  std::vector<Pose2> poses;
  for (const auto& scan : recording.scans) poses.push_back(scan.T_world_robot);
  return poses;
}

ChartSeries pathOf(const std::string& name, const std::vector<Pose2>& poses)
{
  ChartSeries series;
  series.name = name;
  for (const auto& pose : poses) series.points.push_back(pose.translation());
  return series;
}

/** The errors of all scans over the distance driven. */
ChartSeries errorsOf(const std::string& name, const std::vector<Pose2>& poses,
                     const std::vector<Pose2>& truth, const ErrorOf& error)
{
  ChartSeries series;
  series.name = name;
  double way_m = 0;
  for (std::size_t s = 0; s < truth.size(); ++s)
  {
    if (s > 0) way_m += (truth[s].translation() - truth[s - 1].translation()).norm();
    series.points.emplace_back(way_m, error(poses[s], truth[s]));
  }
  return series;
}

ChartSeries wallsOf(const World& world)
{
  Ends ends;
  for (const auto& wall : world.walls()) ends.emplace_back(wall.a, wall.b);
  ChartSeries walls = lineSegments("", ends);
  walls.style = ChartSeries::Style::ThinLine;
  walls.rgb = kWallColour;
  return walls;
}

Chart pathChart(const Drive& drive, const std::vector<MethodRun>& runs)
{
  Chart chart;
  chart.title = "Paths";
  chart.xLabel = "x, m";
  chart.yLabel = "y, m";
  chart.equalAspect = true;
  chart.series.push_back(wallsOf(drive.site.world));
  chart.series.push_back(pathOf("odometry", odometryPoses(drive.recording)));
  chart.series.back().style = ChartSeries::Style::DashedLine;
  chart.series.back().rgb = kOdometryColour;
  for (const auto& run : runs) chart.series.push_back(pathOf(run.method.name, run.T_world_robot));
  chart.series.push_back(pathOf("truth", truePoses(drive.recording)));
  chart.series.back().style = ChartSeries::Style::ThinLine;
  chart.series.back().rgb = kTruthColour;
  return chart;
}

/** The errors on a logarithmic axis, so that those of odometry and of psmks are seen together. */
Chart errorChart(const Drive& drive, const std::vector<MethodRun>& runs, const std::string& title,
                 const std::string& label, const ErrorOf& error)
{
  const std::vector<Pose2> truth = truePoses(drive.recording);
  Chart chart;
  chart.title = title;
  chart.xLabel = "way, m";
  chart.yLabel = label;
  chart.yRange.logarithmic = true;
  chart.series.push_back(errorsOf("odometry", odometryPoses(drive.recording), truth, error));
  chart.series.back().style = ChartSeries::Style::DashedLine;
  chart.series.back().rgb = kOdometryColour;
  for (const auto& run : runs)
    chart.series.push_back(errorsOf(run.method.name, run.T_world_robot, truth, error));
  return chart;
}

Chart mapChart(const std::string& title, const std::vector<PosedScan>& scans,
               const Pose2& T_world_start, const MatcherOptions& options)
{
  Ends ends;
  for (const auto& wall : makeScanMap(scans, options).walls)
    ends.emplace_back(T_world_start * wall.from_m, T_world_start * wall.to_m);
  Chart chart;
  chart.title = title;
  chart.xLabel = "x, m";
  chart.yLabel = "y, m";
  chart.equalAspect = true;
  chart.series.push_back(lineSegments("", ends));
  chart.series.back().style = ChartSeries::Style::ThinLine;
  chart.series.back().rgb = kMapColour;
  return chart;
}
}  // namespace

Figure pathFigure(const Drive& drive, const std::vector<MethodRun>& runs)
{
  Figure figure;
  figure.columns = 3;
  figure.panels = {pathChart(drive, runs),
                   errorChart(drive, runs, "Errors in position", "dr, cm", positionError_cm),
                   errorChart(drive, runs, "Errors in heading", "|dtheta|, deg", headingError_deg)};
  return figure;
}

Figure mapFigure(const Drive& drive, const MethodRun& run, const MatcherOptions& options)
{
  const Pose2& T_world_start = drive.recording.scans.front().T_world_robot;
  std::vector<PosedScan> byOdometry = run.scans;
  for (auto& scan : byOdometry) scan.T_world_robot.pose = scan.T_world_odometry;

  Figure figure;
  figure.panels = {mapChart("Map by " + run.method.name, run.scans, T_world_start, options),
                   mapChart("The same segments by odometry", byOdometry, T_world_start, options)};
  return figure;
}
}  // namespace psmks
