/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/LogRun.h>
#include <psmks/core/Stopwatch.h>
#include <psmks/mrpt/TrajectoryBuilder.h>

#include <limits>

namespace psmks
{
namespace
{
constexpr double kMillisecondsPerSecond = 1e3;

const std::vector<Table::Column> kColumns{{"matcher", "matcher"},
                                          {"reference", "reference"},
                                          {"scans", "scans"},
                                          {"matches", "matches"},
                                          {"failed", "failed"},
                                          {"occupied cells", "occupied_cells_5cm"},
                                          {"path m", "path_m", 2},
                                          {"mean error m", "error_mean_m", 3},
                                          {"max error m", "error_max_m", 3},
                                          {"median ms a match", "match_median_ms", 3},
                                          {"p95 ms", "match_p95_ms", 3},
                                          {"scans/s", "scans_per_s"}};

std::vector<Table::Cell> tableRow(const LogRun& run)
{
  constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();
  const Summary& s = run.summary;
  return {run.matcher,
          run.reference,
          static_cast<double>(s.scans),
          static_cast<double>(s.matches),
          static_cast<double>(s.failures()),
          static_cast<double>(s.occupiedCells),
          s.pathLength_m,
          s.error ? s.error->mean_m : kNoValue,
          s.error ? s.error->max_m : kNoValue,
          kMillisecondsPerSecond * s.matchMedian_s,
          kMillisecondsPerSecond * s.matchP95_s,
          static_cast<double>(s.scans) / run.time_s};
}
}  // namespace

LogRun runLog(const Log& log, const std::string& matcher, const std::string& reference,
              SlamOptions options)
{
  options.set("reference.choice=" + reference);
  TrajectoryBuilder builder(makePairMatcher(matcher, options.matching.matcher), options.reference,
                            options.odometry);
  Stopwatch stopwatch;
  for (const auto& scan : log.scans) builder.add(scan.scan, scan.T_robot_sensor, scan.odometry);
  builder.settle();

  LogRun run{matcher, reference, {}, stopwatch.lap_s()};
  run.summary = summarise(builder.scans(), log.groundTruth);
  return run;
}

Table logTable(const std::string& title, const std::vector<LogRun>& runs)
{
  Table table{title, kColumns, {}};
  for (const auto& run : runs) table.rows.push_back(tableRow(run));
  return table;
}
}  // namespace psmks
