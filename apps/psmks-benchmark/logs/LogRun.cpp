/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/logs/LogRun.h>
#include <apps/psmks-benchmark/logs/WorstMotions.h>
#include <psmks/base/Stopwatch.h>
#include <psmks/eval/Jumps.h>
#include <psmks/slam/TrajectoryBuilder.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace psmks
{
namespace
{
constexpr double kMillisecondsPerSecond = 1e3;
constexpr double kPercent = 100;
constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

const std::vector<Table::Column> kColumns{{"matcher", "matcher"},
                                          {"reference", "reference"},
                                          {"scans", "scans"},
                                          {"matches", "matches"},
                                          {"failed", "failed"},
                                          {"jumps", "jumps"},
                                          {"relations m", "relations_mean_m", 3},
                                          {"+- m", "relations_deviation_m", 3},
                                          {"deg", "relations_mean_deg", 2},
                                          {"+- deg", "relations_deviation_deg", 2},
                                          {"< 5 s: m", "short_relations_mean_m", 4},
                                          {"+- m", "short_relations_deviation_m", 4},
                                          {"deg", "short_relations_mean_deg", 3},
                                          {"+- deg", "short_relations_deviation_deg", 3},
                                          {"mean error m", "error_mean_m", 3},
                                          {"max error m", "error_max_m", 3},
                                          {"best fit m", "error_aligned_mean_m", 3},
                                          {"occupied cells", "occupied_cells_5cm"},
                                          {"path m", "path_m", 2},
                                          {"median ms a match", "match_median_ms", 3},
                                          {"p95 ms", "match_p95_ms", 3},
                                          {"scans/s", "scans_per_s"},
                                          {"segmentation %", "segmentation_percent"}};

std::vector<Table::Cell> tableRow(const LogRun& run)
{
  const Summary& s = run.summary;
  return {run.matcher,
          run.reference,
          static_cast<double>(s.scans),
          static_cast<double>(s.matches),
          static_cast<double>(s.failures()),
          run.jumps ? *run.jumps : kNoValue,
          run.relations.translation_m.mean,
          run.relations.translation_m.std,
          radToDeg(run.relations.rotation_rad.mean),
          radToDeg(run.relations.rotation_rad.std),
          run.shortRelations.translation_m.mean,
          run.shortRelations.translation_m.std,
          radToDeg(run.shortRelations.rotation_rad.mean),
          radToDeg(run.shortRelations.rotation_rad.std),
          s.error ? s.error->mean_m : kNoValue,
          s.error ? s.error->max_m : kNoValue,
          s.error ? s.error->alignedMean_m : kNoValue,
          static_cast<double>(s.occupiedCells),
          s.pathLength_m,
          kMillisecondsPerSecond * s.matchMedian_s,
          kMillisecondsPerSecond * s.matchP95_s,
          static_cast<double>(s.scans) / run.time_s,
          kPercent * run.segmentation_s / run.time_s};
}

double segmentationTime_s(const std::vector<PosedScan>& scans)
{
  double sum_s = 0;
  for (const PosedScan& scan : scans)
    for (const auto* matches : {&scan.matches, &scan.links})
      for (const ReferenceMatch& match : *matches) sum_s += match.result.times.segmentation_s;
  return sum_s;
}

std::vector<Relation> shortRelations(const std::vector<Relation>& relations)
{
  std::vector<Relation> some;
  std::copy_if(relations.begin(), relations.end(), std::back_inserter(some),
               [](const Relation& r) { return std::abs(r.to_s - r.from_s) < kShortSpan_s; });
  return some;
}

void compareWithTruth(const Log& log, const std::vector<PosedScan>& scans, std::size_t drawn,
                      LogRun& run)
{
  const Trajectory estimate = trajectoryOf(scans);
  const RelationStatistics relations = relationStatistics(estimate, log.relations);
  run.relations = relations.all;
  run.shortRelations = relations.shortSpans;
  const std::vector<Relation> some = shortRelations(log.relations);
  if (!log.groundTruth && some.empty()) return;

  const MatchedPath matched(scans);
  const std::vector<Relation> motions =
      log.groundTruth ? trueSteps(matched.estimate, *log.groundTruth) : some;
  if (motions.empty()) return;  // stamps that are numbers of rows give no motions
  run.jumps = countJumps(matched.estimate, matched.odometry, motions);
  if (drawn > 0)
    run.worst = worstMotions(log.title + ", " + run.matcher + ", " + run.reference, scans, matched,
                             motions, drawn);
}
}  // namespace

LogRun runLog(const Log& log, const std::string& matcher, const std::string& reference,
              SlamOptions options, std::size_t drawn)
{
  options.set("reference.choice=" + reference);
  TrajectoryBuilder builder(makePairMatcher(matcher, options.matching.matcher), options.reference,
                            options.odometry);
  Stopwatch stopwatch;
  for (const auto& scan : log.scans) builder.add(scan.scan, scan.T_robot_sensor, scan.odometry);
  builder.optimise();

  LogRun run;
  run.matcher = matcher;
  run.reference = reference;
  run.time_s = stopwatch.lap_s();
  run.segmentation_s = segmentationTime_s(builder.scans());
  run.summary = summarise(builder.scans(), log.groundTruth);
  compareWithTruth(log, builder.scans(), drawn, run);
  return run;
}

Table logTable(const std::string& title, const std::vector<LogRun>& runs)
{
  Table table{title, kColumns, {}};
  for (const auto& run : runs) table.rows.push_back(tableRow(run));
  return table;
}
}  // namespace psmks
