/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-slam/SummaryOutput.h>
#include <apps/support/StopSignal.h>
#include <mrpt/system/os.h>
#include <psmks/geometry/Angle.h>

#include <algorithm>
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

double toMm(double x_m)
{
  constexpr double kMmPerMetre = 1e3;
  return kMmPerMetre * x_m;
}

std::string listed(const std::map<std::string, std::size_t>& counts)
{
  std::string text;
  for (const auto& [status, count] : counts)
    text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + status;
  return text.empty() ? "none" : text;
}

Json numberOrNull(double value) { return std::isnan(value) ? Json() : Json(value); }

/** An option as what it is: a number, true or false, or a text. */
Json valueJson(const std::string& text)
{
  Json value = Json::parse(text, nullptr, false);
  return value.is_number() || value.is_boolean() ? value : Json(text);
}

Json optionsJson(SlamOptions& options)
{
  Json json;
  for (const auto& field : options.fields())
    json[field.section][field.key] = valueJson(field.get());
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

Json relationsJson(const PairErrorStatistics& s)
{
  return {{"relations", s.count},
          {"mean_m", numberOrNull(s.translation_m.mean)},
          {"std_m", numberOrNull(s.translation_m.std)},
          {"mean_deg", numberOrNull(radToDeg(s.rotation_rad.mean))},
          {"std_deg", numberOrNull(radToDeg(s.rotation_rad.std))}};
}

Json timesJson(const RunTimes& times)
{
  return {{"reading", times.reading_s},
          {"segmentation", times.segmentation_s},
          {"matching", times.matching_s},
          {"map", times.map_s},
          {"output", times.output_s}};
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

/** Says where the odometry jumps; nothing where it does not. */
void printJumps(std::ostream& out, const std::vector<OdometryJump>& jumps)
{
  /** Most jumps that are told one by one. Unit: jumps. Definition: a few lines. */
  constexpr std::size_t kMost = 3;
  for (std::size_t i = 0; i < std::min(kMost, jumps.size()); ++i)
    out << "odometry jumps   by " << jumps[i].distance_m << " m, " << radToDeg(jumps[i].angle_rad)
        << " deg at scan " << jumps[i].scan << "; the scans bridge it\n";
  if (jumps.size() > kMost)
    out << "                 and " << jumps.size() - kMost << " times more\n";
}

Json jumpsJson(const std::vector<OdometryJump>& jumps)
{
  Json json = Json::array();
  for (const OdometryJump& jump : jumps)
    json.push_back({{"scan", jump.scan},
                    {"distance_m", jump.distance_m},
                    {"angle_deg", radToDeg(jump.angle_rad)}});
  return json;
}

void printErrors(std::ostream& out, const TrajectoryError& e)
{
  out << std::setprecision(1) << "position error   mean " << toMm(e.mean_m) << " mm, rms "
      << toMm(e.rms_m) << " mm, max " << toMm(e.max_m) << " mm at " << e.poses << " poses\n"
      << std::setprecision(3);
  if (std::isnan(e.mean_rad)) return;
  out << "heading error    mean " << radToDeg(e.mean_rad) << " deg, rms " << radToDeg(e.rms_rad)
      << " deg, max " << radToDeg(e.max_rad) << " deg\n";
}

void printErrors(std::ostream& out, const std::string& heading, const PairErrorStatistics& s)
{
  out << heading << std::setprecision(1) << toMm(s.translation_m.mean) << " +- "
      << toMm(s.translation_m.std) << " mm, " << std::setprecision(3)
      << radToDeg(s.rotation_rad.mean) << " +- " << radToDeg(s.rotation_rad.std) << " deg over "
      << s.count << '\n';
}

void printTimes(std::ostream& out, const RunSummary& run)
{
  constexpr double kPercent = 100;
  const RunTimes& t = run.times;
  const double share = kPercent / t.total_s();
  out << "speed            " << std::setprecision(0) << run.scansPerSecond()
      << " scans/s; of the run's " << std::setprecision(2) << t.total_s() << " s "
      << std::setprecision(0) << share * t.reading_s << " % reading, " << share * t.segmentation_s
      << " % segmentation, " << share * t.matching_s << " % matching, " << share * t.map_s
      << " % map, " << share * t.output_s << " % output\n"
      << std::setprecision(2);
}
}  // namespace

double RunSummary::scansPerSecond() const
{
  return static_cast<double>(trajectory.scans) / times.building_s();
}

void printSummary(std::ostream& out, const RunSummary& run)
{
  const Summary& s = run.trajectory;
  out << std::fixed << std::setprecision(2);
  out << "scans            " << s.scans << ", every one posed, " << s.unmatched
      << " by odometry alone\n";
  out << "matches          " << s.matches << " by " << s.matcher << " against " << s.references
      << " reference scans: " << listed(s.usable) << '\n';
  out << "failures         " << listed(s.failed) << '\n';
  printJumps(out, s.odometryJumps);
  out << "path length      " << s.pathLength_m << " m\n";
  if (s.matches > 0)
    out << "time per match   median " << kMsPerSecond * s.matchMedian_s << " ms, 95 % below "
        << kMsPerSecond * s.matchP95_s << " ms; of it segmentation "
        << kMsPerSecond * s.segmentationMedian_s << " ms\n";
  printTimes(out, run);
  out << "occupied cells   " << s.occupiedCells << " of 5 cm\n";
  if (s.error) printErrors(out, *s.error);
  if (!run.relations) return;
  printErrors(out, "relations        ", run.relations->all);
  printErrors(out, "  spanning < 5 s ", run.relations->shortSpans);
}

void writeSummaryJson(std::ostream& out, const RunSummary& run, SlamOptions& options)
{
  const Summary& s = run.trajectory;
  Json json{{"log", logJson(s.log)},
            {"remarks", run.remarks},
            {"stopped_by_signal", stopSignal()},
            {"matcher", s.matcher},
            {"scans", s.scans},
            {"scans_by_odometry_alone", s.unmatched},
            {"references", s.references},
            {"matches", s.matches},
            {"matches_by_status", s.usable},
            {"failures", s.failures()},
            {"failures_by_status", s.failed},
            {"odometry_jumps", jumpsJson(s.odometryJumps)},
            {"path_length_m", s.pathLength_m},
            {"match_median_ms", numberOrNull(kMsPerSecond * s.matchMedian_s)},
            {"match_p95_ms", numberOrNull(kMsPerSecond * s.matchP95_s)},
            {"segmentation_median_ms", numberOrNull(kMsPerSecond * s.segmentationMedian_s)},
            {"scans_per_second", numberOrNull(run.scansPerSecond())},
            {"time_s", timesJson(run.times)},
            {"occupied_cells_5cm", s.occupiedCells}};
  if (s.error) json["ground_truth_error"] = errorJson(*s.error);
  if (run.relations)
    json["relations_error"] = {{"all", relationsJson(run.relations->all)},
                               {"spanning_below_5s", relationsJson(run.relations->shortSpans)}};
  json["options"] = optionsJson(options);
  json["versions"] = {{"psmks", PSMKS_VERSION}, {"mrpt", mrpt::system::MRPT_getVersion()}};
  // A name in a damaged log need not be UTF-8.
  out << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}
}  // namespace psmks
