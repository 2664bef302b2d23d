/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-slam/Summary.h>
#include <mrpt/system/os.h>
#include <psmks/core/Angle.h>
#include <psmks/eval/OccupiedCells.h>
#include <psmks/eval/Statistics.h>

#include <cmath>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <ostream>

namespace psmks
{
namespace
{
using Json = nlohmann::ordered_json;

constexpr double kMsPerSecond = 1e3;

std::size_t occupiedCells(const std::vector<PosedScan>& scans)
{
  OccupiedCells cells;
  if (scans.empty()) return 0;
  const Pose2 T_first_world = scans.front().T_world_sensor().inverse();
  for (const auto& scan : scans) cells.add(scan.scan, T_first_world * scan.T_world_sensor());
  return cells.count();
}

void addTimes(const std::vector<PosedScan>& scans, Summary& summary)
{
  std::vector<double> match_s, segmentation_s;
  for (const auto& scan : scans)
  {
    for (const auto& match : scan.matches)
    {
      match_s.push_back(match.time_s);
      segmentation_s.push_back(match.result.times.segmentation_s);
    }
  }
  constexpr double kP95 = 0.95;
  summary.matchMedian_s = median(match_s);
  summary.matchP95_s = quantile(match_s, kP95);
  summary.segmentationMedian_s = median(segmentation_s);
}

std::string listed(const std::map<std::string, std::size_t>& counts)
{
  std::string text;
  for (const auto& [status, count] : counts)
    text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + status;
  return text.empty() ? "none" : text;
}

Json numberOrNull(double value) { return std::isnan(value) ? Json() : Json(value); }

Json optionsJson(SlamOptions& options)
{
  Json json;
  for (const auto& field : options.fields()) json[field.section][field.key] = field.get();
  return json;
}

Json errorJson(const TrajectoryError& e)
{
  return {{"poses", e.poses},
          {"mean_m", numberOrNull(e.mean_m)},
          {"rms_m", numberOrNull(e.rms_m)},
          {"max_m", numberOrNull(e.max_m)},
          {"mean_deg", numberOrNull(radToDeg(e.mean_rad))},
          {"rms_deg", numberOrNull(radToDeg(e.rms_rad))},
          {"max_deg", numberOrNull(radToDeg(e.max_rad))}};
}

Json logJson(const LogSummary& log)
{
  return {{"path", log.path},
          {"sensor", log.sensor},
          {"entries_read", log.entriesRead},
          {"damage", log.damage},
          {"scans_without_odometry", log.scansWithoutOdometry},
          {"stamps_made_up", log.stampsMadeUp}};
}
}  // namespace

std::size_t Summary::failures() const
{
  std::size_t sum = 0;
  for (const auto& [status, count] : failed) sum += count;
  return sum;
}

Summary summarise(const std::vector<PosedScan>& scans)
{
  Summary summary;
  summary.scans = scans.size();
  for (const auto& scan : scans)
  {
    summary.references += scan.isReference;
    summary.pathLength_m += scan.T_last_robot.pose.translation().norm();
    summary.unmatched += !scan.isMatched();
    summary.matches += scan.matches.size();
    for (const auto& [reference, T_ref_cur, result, time_s] : scan.matches)
      ++(result.usable() ? summary.usable : summary.failed)[toString(result.status)];
  }
  if (!scans.empty()) --summary.unmatched;
  addTimes(scans, summary);
  summary.occupiedCells = occupiedCells(scans);
  return summary;
}

Trajectory trajectoryOf(const std::vector<PosedScan>& scans)
{
  Trajectory trajectory;
  for (const auto& scan : scans) trajectory.push_back({scan.stamp_s(), scan.T_world_robot.pose});
  return trajectory;
}

Trajectory odometryOf(const std::vector<PosedScan>& scans)
{
  Trajectory trajectory;
  for (const auto& scan : scans) trajectory.push_back({scan.stamp_s(), scan.T_world_odometry});
  return trajectory;
}

void printSummary(std::ostream& out, const Summary& s)
{
  out << std::fixed << std::setprecision(2);
  out << "scans            " << s.scans << ", every one posed, " << s.unmatched
      << " by odometry alone\n";
  out << "matches          " << s.matches << " by " << s.matcher << " against " << s.references
      << " reference scans: " << listed(s.usable) << '\n';
  out << "failures         " << listed(s.failed) << '\n';
  out << "path length      " << s.pathLength_m << " m\n";
  if (s.matches > 0)
    out << "time per match   median " << kMsPerSecond * s.matchMedian_s << " ms, 95 % below "
        << kMsPerSecond * s.matchP95_s << " ms; of it segmentation "
        << kMsPerSecond * s.segmentationMedian_s << " ms\n";
  out << "occupied cells   " << s.occupiedCells << " of 5 cm\n";
  if (!s.error) return;
  out << "position error   mean " << s.error->mean_m << " m, rms " << s.error->rms_m << " m, max "
      << s.error->max_m << " m at " << s.error->poses << " poses\n";
  out << "heading error    mean " << radToDeg(s.error->mean_rad) << " deg, rms "
      << radToDeg(s.error->rms_rad) << " deg, max " << radToDeg(s.error->max_rad) << " deg\n";
}

void writeSummaryJson(std::ostream& out, const Summary& s, SlamOptions& options)
{
  Json json{{"log", logJson(s.log)},
            {"matcher", s.matcher},
            {"scans", s.scans},
            {"scans_by_odometry_alone", s.unmatched},
            {"references", s.references},
            {"matches", s.matches},
            {"matches_by_status", s.usable},
            {"failures", s.failures()},
            {"failures_by_status", s.failed},
            {"path_length_m", s.pathLength_m},
            {"match_median_ms", numberOrNull(kMsPerSecond * s.matchMedian_s)},
            {"match_p95_ms", numberOrNull(kMsPerSecond * s.matchP95_s)},
            {"segmentation_median_ms", numberOrNull(kMsPerSecond * s.segmentationMedian_s)},
            {"occupied_cells_5cm", s.occupiedCells}};
  if (s.error) json["ground_truth_error"] = errorJson(*s.error);
  json["options"] = optionsJson(options);
  json["versions"] = {{"psmks", PSMKS_VERSION}, {"mrpt", mrpt::system::MRPT_getVersion()}};
  out << json.dump(2) << '\n';
}
}  // namespace psmks
