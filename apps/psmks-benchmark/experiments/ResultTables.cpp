/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/experiments/PaperFigures.h>
#include <apps/psmks-benchmark/experiments/ResultTables.h>

#include <cstdio>
#include <limits>

namespace psmks
{
namespace
{
constexpr double kCentimetre = 100;
constexpr double kMillisecond = 1e3;
constexpr double kPercent = 100;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::string number(double value, int decimals)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

/** A spread as text in a unit: "4.1 (3.2 to 5.0)". */
std::string cell(const Spread& s, int decimals, double unit = 1)
{
  const std::string centre = number(s.mean * unit, decimals);
  if (s.smallest == s.largest) return centre;
  return centre + " (" + number(s.smallest * unit, decimals) + " to " +
         number(s.largest * unit, decimals) + ")";
}

/** The methods of a group. They are those of its first drive, for all drives of a group have the
 * same ones. */
const std::vector<std::pair<Method, MethodFigures>>& methodsOf(const ResultGroup& group)
{
  return group.drives.front().methods;
}

/** The name of a site with its letter in the paper: "room (a)". */
std::string siteName(const ResultGroup& group)
{
  const auto paper = paperFigures(group.site);
  return paper ? group.site + " (" + paper->map + ")" : group.site;
}

Table::Cell paperCell(const ResultGroup& group, double PaperFigures::*figure, double unit = 1)
{
  const auto paper = paperFigures(group.site);
  return paper ? (*paper).*figure * unit : kNone;
}

double meanDrift_m(const MethodFigures& f) { return f.drift.mean_m; }
double meanDrift_deg(const MethodFigures& f) { return radToDeg(f.drift.mean_rad); }
double odometry_m(const MethodFigures& f) { return f.odometryDrift.mean_m; }
double odometry_deg(const MethodFigures& f) { return radToDeg(f.odometryDrift.mean_rad); }
double lowestDrift_m(const MethodFigures& f) { return f.boundDrift.mean_m; }
double lowestDrift_deg(const MethodFigures& f) { return radToDeg(f.boundDrift.mean_rad); }

/** Whether the mean errors of both position and heading are smaller. */
bool isBetter(const DriftFigures& a, const DriftFigures& b)
{
  return a.mean_m < b.mean_m && a.mean_rad < b.mean_rad;
}

/** The number of drives in which a method is better than a rival, such as "10 of 10".
 *  @param rival gives the drift to compare with; null if a drive has none */
std::string drivesWon(const ResultGroup& group, const std::string& key,
                      const std::function<const DriftFigures*(const DriveResult&)>& rival)
{
  int won = 0, compared = 0;
  for (const auto& drive : group.drives)
  {
    const DriftFigures* other = rival(drive);
    const MethodFigures* own = drive.find(key);
    if (!other || !own) continue;
    ++compared;
    won += isBetter(own->drift, *other) ? 1 : 0;
  }
  return std::to_string(won) + " of " + std::to_string(compared);
}

double total(const ResultGroup& group, const std::string& key, int MethodFigures::*count)
{
  int sum = 0;
  for (const auto& drive : group.drives)
    if (const MethodFigures* figures = drive.find(key)) sum += figures->*count;
  return sum;
}

std::vector<Table::Cell> driftRow(const ResultGroup& group, const Method& method)
{
  const auto max_m = [](const MethodFigures& f) { return f.drift.max_m; };
  const auto max_deg = [](const MethodFigures& f) { return radToDeg(f.drift.max_rad); };
  const Spread drift_m = spread(group, method.key, meanDrift_m);
  const Spread drift_deg = spread(group, method.key, meanDrift_deg);
  const double lowest_m = spread(group, method.key, lowestDrift_m).mean;
  const double lowest_deg = spread(group, method.key, lowestDrift_deg).mean;
  return {siteName(group),
          group.maxRange_m,
          method.name,
          cell(drift_m, 1, kCentimetre),
          spread(group, method.key, max_m).largest * kCentimetre,
          cell(drift_deg, 2),
          spread(group, method.key, max_deg).largest,
          lowest_m * kCentimetre,
          lowest_deg,
          drift_m.mean / lowest_m,
          drift_deg.mean / lowest_deg,
          spread(group, method.key, odometry_m).mean / drift_m.mean,
          spread(group, method.key, odometry_deg).mean / drift_deg.mean};
}

std::vector<Table::Cell> driftRowOfPaper(const ResultGroup& group, const PaperFigures& paper)
{
  return {siteName(group),
          kNone,
          "the paper, on its own map",
          number(paper.drift_m * kCentimetre, 1),
          kNone,
          number(paper.drift_deg, 2),
          kNone,
          kNone,
          kNone,
          kNone,
          kNone,
          paper.timesBetter(),
          paper.timesBetterHeading()};
}

/** The counts of failures, of unobservable directions and of errors without a flag, and the
 * comparison with odometry and with the scheme of the paper. */
std::vector<Table::Cell> reliabilityRow(const ResultGroup& group, const Method& method)
{
  const std::string& key = method.key;
  const auto odometry = [&key](const DriveResult& d) { return &d.find(key)->odometryDrift; };
  const auto paper = [](const DriveResult& d) -> const DriftFigures*
  {
    const MethodFigures* figures = d.find(paperMethod().key);
    return figures ? &figures->drift : nullptr;
  };
  const auto worst_m = [](const MethodFigures& f) { return f.worstMatch_m; };
  const auto worst_deg = [](const MethodFigures& f) { return radToDeg(f.worstMatch_rad); };
  const auto ends = [](const MethodFigures& f) { return f.wallEndsShare; };
  return {siteName(group),
          group.maxRange_m,
          method.name,
          total(group, key, &MethodFigures::matches),
          total(group, key, &MethodFigures::failures),
          total(group, key, &MethodFigures::degenerate),
          total(group, key, &MethodFigures::silentErrors),
          spread(group, key, worst_m).largest * kCentimetre,
          spread(group, key, worst_deg).largest,
          drivesWon(group, key, odometry),
          key == paperMethod().key ? "-" : drivesWon(group, key, paper),
          spread(group, key, ends).mean * kPercent};
}
}  // namespace

Table driveTable(const std::vector<ResultGroup>& groups)
{
  Table table;
  table.title = "Drives";
  table.columns = {{"world", "world", 0},
                   {"range, m", "range_m", 0},
                   {"drives", "drives", 0},
                   {"way, m", "way_m", 0},
                   {"paper", "paper_way_m", 0},
                   {"turns", "turns", 0},
                   {"paper", "paper_turns", 1},
                   {"collisions", "collisions", 0},
                   {"longest standstill, s", "standstill_s", 0},
                   {"odometry dr, cm", "odometry_cm", 0},
                   {"paper", "paper_odometry_cm", 0},
                   {"odometry dtheta, deg", "odometry_deg", 0},
                   {"paper", "paper_odometry_deg", 1}};
  for (const auto& group : groups)
  {
    const std::string& key = methodsOf(group).front().first.key;
    const auto standstill_s = [](const DriveResult& d) { return d.longestStandstill_s; };
    const auto collisions = [](const DriveResult& d) { return d.collisions; };
    table.rows.push_back(
        {siteName(group), group.maxRange_m, static_cast<double>(group.drives.size()),
         cell(spread(group, [](const DriveResult& d) { return d.distance_m; }), 0),
         paperCell(group, &PaperFigures::distance_m),
         cell(spread(group, [](const DriveResult& d) { return d.turns; }), 1),
         paperCell(group, &PaperFigures::turns), spread(group, collisions).largest,
         spread(group, standstill_s).largest, cell(spread(group, key, odometry_m), 0, kCentimetre),
         paperCell(group, &PaperFigures::odometryDrift_m, kCentimetre),
         cell(spread(group, key, odometry_deg), 1),
         paperCell(group, &PaperFigures::odometryDrift_deg)});
  }
  return table;
}

Table workTable(const std::vector<ResultGroup>& groups)
{
  Table table;
  table.title = "Table 1";
  table.columns = {{"world", "world", 0},
                   {"range, m", "range_m", 0},
                   {"method", "method", 0},
                   {"matches", "matches", 0},
                   {"paper's", "paper_matches", 0},
                   {"segmentation, ms", "segmentation_ms", 3},
                   {"paper's", "paper_segmentation_ms", 2},
                   {"match, ms", "match_ms", 3},
                   {"paper's", "paper_match_ms", 2}};
  for (const auto& group : groups)
    for (const auto& [method, unused] : methodsOf(group))
    {
      const auto matches = [](const MethodFigures& f) { return f.matches; };
      const auto segmentation_s = [](const MethodFigures& f) { return f.meanSegmentation_s; };
      const auto match_s = [](const MethodFigures& f) { return f.meanMatch_s; };
      const bool isPapers = method.key == paperMethod().key;
      const auto papers = [&](double PaperFigures::*figure) -> Table::Cell
      { return isPapers ? paperCell(group, figure) : kNone; };
      table.rows.push_back({siteName(group), group.maxRange_m, method.name,
                            cell(spread(group, method.key, matches), 0),
                            papers(&PaperFigures::matches),
                            spread(group, method.key, segmentation_s).mean * kMillisecond,
                            papers(&PaperFigures::segmentation_ms),
                            spread(group, method.key, match_s).mean * kMillisecond,
                            papers(&PaperFigures::match_ms)});
    }
  return table;
}

Table driftTable(const std::vector<ResultGroup>& groups)
{
  Table table;
  table.title = "Table 2";
  table.columns = {{"world", "world", 0},
                   {"range, m", "range_m", 0},
                   {"method", "method", 0},
                   {"mean dr, cm", "mean_cm", 0},
                   {"max dr, cm", "max_cm", 1},
                   {"mean dtheta, deg", "mean_deg", 0},
                   {"max dtheta, deg", "max_deg", 2},
                   {"floor dr, cm", "floor_cm", 2},
                   {"floor dtheta, deg", "floor_deg", 3},
                   {"dr / floor", "floors", 1},
                   {"dtheta / floor", "heading_floors", 1},
                   {"odometry / dr", "times_better", 1},
                   {"odometry / dtheta", "times_better_heading", 1}};
  for (const auto& group : groups)
  {
    for (const auto& [method, unused] : methodsOf(group))
      table.rows.push_back(driftRow(group, method));
    if (const auto paper = paperFigures(group.site))
      table.rows.push_back(driftRowOfPaper(group, *paper));
  }
  return table;
}

Table reliabilityTable(const std::vector<ResultGroup>& groups)
{
  Table table;
  table.title = "Trust";
  table.columns = {{"world", "world", 0},
                   {"range, m", "range_m", 0},
                   {"method", "method", 0},
                   {"accepted", "accepted", 0},
                   {"refused", "refused", 0},
                   {"degenerate", "degenerate", 0},
                   {"silent errors", "silent_errors", 0},
                   {"worst match, cm", "worst_cm", 1},
                   {"worst match, deg", "worst_deg", 2},
                   {"better than odometry", "better_than_odometry", 0},
                   {"better than paper scheme", "better_than_paper_scheme", 0},
                   {"ends on walls, %", "ends_on_walls_percent", 1}};
  for (const auto& group : groups)
    for (const auto& [method, unused] : methodsOf(group))
      table.rows.push_back(reliabilityRow(group, method));
  return table;
}

Table runTable(const std::vector<DriveResult>& results)
{
  Table table;
  table.title = "Every drive";
  table.columns = {{"world", "world", 0},
                   {"range, m", "range_m", 0},
                   {"seed", "seed", 0},
                   {"method", "method", 0},
                   {"matches", "matches", 0},
                   {"mean dr, cm", "mean_cm", 1},
                   {"max dr, cm", "max_cm", 1},
                   {"mean dtheta, deg", "mean_deg", 2},
                   {"max dtheta, deg", "max_deg", 2},
                   {"odometry mean dr, cm", "odometry_mean_cm", 1},
                   {"max", "odometry_max_cm", 1},
                   {"mean dtheta, deg", "odometry_mean_deg", 2},
                   {"max", "odometry_max_deg", 2},
                   {"floor dr, cm", "floor_cm", 2},
                   {"floor dtheta, deg", "floor_deg", 3}};
  for (const auto& drive : results)
    for (const auto& [method, f] : drive.methods)
      table.rows.push_back(
          {drive.plan.site, drive.plan.maxRange_m, static_cast<double>(drive.plan.seed),
           method.name, static_cast<double>(f.matches), f.drift.mean_m * kCentimetre,
           f.drift.max_m * kCentimetre, radToDeg(f.drift.mean_rad), radToDeg(f.drift.max_rad),
           f.odometryDrift.mean_m * kCentimetre, f.odometryDrift.max_m * kCentimetre,
           radToDeg(f.odometryDrift.mean_rad), radToDeg(f.odometryDrift.max_rad),
           f.boundDrift.mean_m * kCentimetre, radToDeg(f.boundDrift.mean_rad)});
  return table;
}
}  // namespace psmks
