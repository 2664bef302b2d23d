/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/drives/DriveCourse.h>
#include <apps/psmks-benchmark/drives/DrivesCommand.h>
#include <apps/support/Progress.h>

#include <utility>

namespace psmks
{
namespace
{
constexpr double kMillisecondsPerSecond = 1e3;
constexpr double kMetresPerKilometre = 1e3;
constexpr double kSecondsPerMinute = 60;

std::vector<Table::Column> driveColumns()
{
  return {{"seed", "seed", 0},
          {"km", "way_km", 2},
          {"scans", "scans", 0},
          {"keyframes", "keyframes", 0},
          {"mean m", "mean_m", 3},
          {"max m", "max_m", 3},
          {"floor mean m", "floor_mean_m", 3},
          {"/ floor", "mean_by_floor", 2},
          {"wrong links", "wrong_links", 0},
          {"segments off walls", "segments_off_walls", 0},
          {"ms a scan", "scan_ms", 3},
          {"last tenth / first", "slowdown", 2},
          {"MB", "memory_MB", 0}};
}

std::vector<Table::Cell> driveRow(unsigned seed, const DriveCourse& course)
{
  double scans = 0, time_s = 0;
  for (const DriveStretch& tenth : course.tenths)
  {
    scans += static_cast<double>(tenth.scans);
    time_s += static_cast<double>(tenth.scans) * tenth.scan_s;
  }
  const DriveStretch& last = course.tenths.back();
  return {static_cast<double>(seed),
          last.way_m / kMetresPerKilometre,
          scans,
          static_cast<double>(last.keyframes),
          course.drift.mean_m,
          course.drift.max_m,
          course.floor.mean_m,
          course.drift.mean_m / course.floor.mean_m,
          static_cast<double>(course.wrongLinks),
          static_cast<double>(course.segmentsOffWalls),
          kMillisecondsPerSecond * time_s / scans,
          course.slowdown(),
          last.memory_MB};
}

std::vector<Table::Column> tenthColumns()
{
  return {{"seed", "seed", 0},           {"tenth", "tenth", 0},       {"km", "way_km", 2},
          {"keyframes", "keyframes", 0}, {"ms a scan", "scan_ms", 3}, {"MB", "memory_MB", 0}};
}

void addTenths(unsigned seed, const DriveCourse& course, Table& table)
{
  double number = 0;
  for (const DriveStretch& tenth : course.tenths)
    table.rows.push_back({static_cast<double>(seed), ++number, tenth.way_m / kMetresPerKilometre,
                          static_cast<double>(tenth.keyframes),
                          kMillisecondsPerSecond * tenth.scan_s, tenth.memory_MB});
}
}  // namespace

DrivesCommand::DrivesCommand(CLI::App& app)
{
  app.add_option("--world", world_, "where to drive")
      ->check(CLI::IsMember(siteNames()))
      ->capture_default_str();
  app.add_option("--seeds", seeds_, "how many drives")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--first-seed", firstSeed_, "of the worlds, the wheels and the laser")
      ->capture_default_str();
  app.add_option("--minutes", minutes_, "of a drive at most; the end of a route ends it, too")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--people", people_, "so many people walk about")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  app.add_flag("--tenths", showTenths_, "time and memory along the way in place of the errors");
  optionFlags_.addTo(app);
  output_.addFlags(app);
}

ExitCode DrivesCommand::run()
{
  const SlamOptions options = optionFlags_.options();
  output_.check();
  Table table{world_, showTenths_ ? tenthColumns() : driveColumns(), {}};
  for (unsigned seed = firstSeed_; seed < firstSeed_ + seeds_; ++seed)
  {
    Progress progress(world_ + " " + std::to_string(seed));
    DrivePlan plan;
    plan.site = world_;
    plan.seed = seed;
    plan.duration_s = minutes_ * kSecondsPerMinute;
    plan.people = people_;
    const Drive drive = makeDrive(plan);
    const DriveCourse course =
        followDrive(drive, options, [&progress](double share) { progress.show(share); });
    if (showTenths_)
      addTenths(seed, course, table);
    else
      table.rows.push_back(driveRow(seed, course));
  }
  output_.write({table});
  return kOk;
}
}  // namespace psmks
