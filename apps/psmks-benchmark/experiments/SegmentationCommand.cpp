/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/experiments/SegmentationCommand.h>
#include <psmks/base/Stopwatch.h>
#include <psmks/eval/SegmentationQuality.h>
#include <psmks/eval/Statistics.h>
#include <psmks/segmentation/Segmentation.h>
#include <psmks/sim/Laser.h>
#include <psmks/sim/World.h>

namespace psmks
{
namespace
{
constexpr double kMinClearance_m = 0.5;  // least distance of the scanner from the walls
constexpr double kPercent = 100;
constexpr double kMillimetresPerMetre = 1e3;
constexpr double kMicrosecondsPerSecond = 1e6;

const std::vector<Table::Column> kColumns{{"world", "world"},
                                          {"filter", "filter"},
                                          {"rays used %", "used_percent", 2},
                                          {"on right wall %", "right_wall_percent", 2},
                                          {"segments/scan", "segments_per_scan", 1},
                                          {"rays/segment", "rays_per_segment", 1},
                                          {"r0 median mm", "r0_median_mm", 2},
                                          {"phi0 median deg", "phi0_median_deg", 3},
                                          {"NEES", "nees_mean", 2},
                                          {"in 95 %", "ellipse_95_percent", 1},
                                          {"median us/scan", "time_median_us", 1}};

WallTruth truthOf(const SimulatedScan& simulated, const World& world, const Pose2& T_world_sensor)
{
  WallTruth truth;
  truth.wallOfRay = simulated.objectOfRay;
  for (std::size_t w = 0; w < world.walls().size(); ++w)
    truth.lines.push_back(world.lineFrom(static_cast<int>(w), T_world_sensor));
  return truth;
}

std::vector<Table::Cell> figures(const SegmentationQuality& quality,
                                 const std::vector<double>& times_s)
{
  return {kPercent * quality.usedShare(),
          kPercent * quality.rightWallShare(),
          quality.segmentsPerScan(),
          quality.raysPerSegment(),
          kMillimetresPerMetre * quality.offsetMedian_m(),
          radToDeg(quality.angleMedian_rad()),
          quality.neesMean(),
          kPercent * quality.ellipseShare(),
          kMicrosecondsPerSecond * median(times_s)};
}
}  // namespace

SegmentationCommand::SegmentationCommand(CLI::App& app)
{
  app.add_option("--filter", filter_, "line filter")
      ->check(CLI::IsMember({"linear", "ekf", "both"}))
      ->capture_default_str();
  app.add_option("--poses", poses_, "random poses of the scanner in each world")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--seed", seed_, "of the cluttered world, the poses and the noise")
      ->capture_default_str();
  output_.addFlags(app);
}

ExitCode SegmentationCommand::run()
{
  output_.check();
  Table table;
  table.title = "segmentation";
  table.columns = kColumns;
  for (const auto& [worldName, world] :
       {std::pair{"room", World::smallRoom()}, std::pair{"clutter", World::smallClutter(seed_)}})
    for (const auto& [filterName, filter] :
         {std::pair{"linear", LineFilter::Linear}, std::pair{"ekf", LineFilter::Ekf}})
      if (filter_ == "both" || filter_ == filterName)
        table.rows.push_back(measure(worldName, world, filterName, filter));
  output_.write({table});
  return kOk;
}

std::vector<Table::Cell> SegmentationCommand::measure(const std::string& worldName,
                                                      const World& world,
                                                      const std::string& filterName,
                                                      LineFilter filter) const
{
  SegmentationOptions options;
  options.filter = filter;
  std::mt19937_64 random(seed_);
  SegmentationBuffers buffers;
  SegmentedScan segmented;
  SegmentationQuality quality;
  std::vector<double> times_s;
  for (int p = 0; p < poses_; ++p)
  {
    const Pose2 T_world_sensor = world.randomFreePose(kMinClearance_m, random);
    const SimulatedScan simulated = castScan(world, T_world_sensor, LaserOptions(), random);
    Stopwatch stopwatch;
    segmentScan(simulated.scan, PreprocessingOptions(), options, buffers, segmented);
    times_s.push_back(stopwatch.lap_s());
    quality.add(segmented, truthOf(simulated, world, T_world_sensor));
  }

  std::vector<Table::Cell> row{worldName, filterName};
  for (auto& cell : figures(quality, times_s)) row.push_back(cell);
  return row;
}
}  // namespace psmks
