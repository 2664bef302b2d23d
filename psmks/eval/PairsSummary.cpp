/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/eval/PairsSummary.h>
#include <psmks/eval/Statistics.h>
#include <psmks/geometry/ChiSquared.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace psmks
{
namespace
{
constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();
constexpr double kMillimetresPerMetre = 1000;
constexpr double kMillisecondsPerSecond = 1000;
constexpr double kPercent = 100;

template <class Value>
std::vector<double> collect(const std::vector<PairRecord>& records, Value value)
{
  std::vector<double> values;
  values.reserve(records.size());
  for (const auto& record : records) values.push_back(value(record));
  return values;
}

template <class Condition>
int count(const std::vector<PairRecord>& records, Condition condition)
{
  return static_cast<int>(std::count_if(records.begin(), records.end(), condition));
}

std::vector<double> neesValues(const std::vector<PairRecord>& records)
{
  std::vector<double> values;
  for (const auto& record : records)
    if (record.statesAccuracy())
      values.push_back(
          nees(record.result.T_ref_cur, record.result.covariance, record.T_ref_cur_true));
  return values;
}

double medianTimeOf_s(const std::vector<PairsRun>& runs, const std::string& matcher,
                      const std::string& guess)
{
  for (const auto& run : runs)
    if (run.matcher == matcher && run.guess == guess) return summarize(run.records).timeMedian_s;
  return kNoValue;
}

std::vector<Table::Cell> tableRow(const PairsRun& run, const PairsSummary& s,
                                  const std::optional<BoundSummary>& bound, double timeUnit_s)
{
  return {run.matcher,
          run.guess,
          kPercent * s.successShare,
          kMillimetresPerMetre * s.translationMedian_m,
          kMillimetresPerMetre * s.translationP95_m,
          bound ? s.translationMedian_m / bound->translationMedian_m : kNoValue,
          radToDeg(s.rotationMedian_rad),
          radToDeg(s.rotationP95_rad),
          static_cast<double>(s.acceptedAndWrong),
          static_cast<double>(s.failed),
          static_cast<double>(s.degenerate),
          s.neesMean,
          kPercent * s.ellipsoidShare,
          kMillisecondsPerSecond * s.timeMedian_s,
          kMillisecondsPerSecond * s.timeP95_s,
          s.timeP95_s / s.timeMedian_s,
          kMillisecondsPerSecond * s.sequentialTimeMedian_s,
          s.timeMedian_s / timeUnit_s};
}

/** The row of the bound, which stands for the best possible matcher. */
std::vector<Table::Cell> boundRow(const std::string& guess, const BoundSummary& bound,
                                  std::size_t columns)
{
  std::vector<Table::Cell> row{"bound",
                               guess,
                               kNoValue,
                               kMillimetresPerMetre * bound.translationMedian_m,
                               kMillimetresPerMetre * bound.translationP95_m,
                               kNoValue,
                               radToDeg(bound.rotationMedian_rad),
                               radToDeg(bound.rotationP95_rad)};
  row.resize(columns, kNoValue);
  return row;
}
}  // namespace

bool PairRecord::statesAccuracy() const
{
  return result.usable() && result.covariance != MatchResult::unknownCovariance();
}

PairsSummary summarize(const std::vector<PairRecord>& records, const PairError& limit)
{
  using R = const PairRecord&;
  const auto translations = collect(records, [](R r) { return r.error().translation_m; });
  const auto rotations = collect(records, [](R r) { return r.error().rotation_rad; });
  const auto successes =
      collect(records, [&limit](R r) { return isSuccess(r.error(), limit) ? 1.0 : 0.0; });
  const auto times = collect(records, [](R r) { return r.time_s; });
  const auto neesOfUsable = neesValues(records);

  PairsSummary s;
  s.pairs = static_cast<int>(records.size());
  s.successShare = mean(successes);
  s.translationMedian_m = median(translations);
  s.translationP95_m = quantile(translations, 0.95);
  s.rotationMedian_rad = median(rotations);
  s.rotationP95_rad = quantile(rotations, 0.95);
  s.acceptedAndWrong = count(
      records, [&limit](R r) { return isAcceptedAndWrong(r.result.status, r.error(), limit); });
  s.failed = count(records, [](R r) { return !r.result.usable(); });
  s.degenerate = count(records, [](R r) { return r.result.status == MatchStatus::Degenerate; });
  s.neesMean = mean(neesOfUsable);
  s.ellipsoidShare = shareBelow(neesOfUsable, kChi2At95With3Dof);
  s.timeMedian_s = median(times);
  s.timeP95_s = quantile(times, 0.95);
  s.sequentialTimeMedian_s = median(collect(records, [](R r) { return r.sequentialTime_s; }));
  return s;
}

Table pairsTable(const std::string& title, const std::vector<PairsRun>& runs,
                 const std::optional<BoundSummary>& bound, const std::string& baseline,
                 const PairError& limit)
{
  Table table;
  table.title = title;
  table.columns = {{"matcher", "matcher"},
                   {"guess", "guess"},
                   {"success %", "success_percent", 1},
                   {"t median mm", "translation_median_mm", 2},
                   {"t p95 mm", "translation_p95_mm", 1},
                   {"t / bound", "translation_median_to_bound", 2},
                   {"r median deg", "rotation_median_deg", 4},
                   {"r p95 deg", "rotation_p95_deg", 3},
                   {"wrong", "accepted_and_wrong", 0},
                   {"failed", "failed", 0},
                   {"degenerate", "degenerate", 0},
                   {"NEES", "nees_mean", 2},
                   {"in 95 %", "ellipsoid_95_percent", 1},
                   {"median ms", "time_median_ms", 3},
                   {"p95 ms", "time_p95_ms", 3},
                   {"p95 / median", "time_p95_to_median", 1},
                   {"sequential ms", "sequential_time_median_ms", 3},
                   {"/ " + baseline, "time_ratio", 2}};
  for (std::size_t r = 0; r < runs.size(); ++r)
  {
    const PairsRun& run = runs[r];
    if (bound && (r == 0 || runs[r - 1].guess != run.guess))
      table.rows.push_back(boundRow(run.guess, *bound, table.columns.size()));
    table.rows.push_back(tableRow(run, summarize(run.records, limit), bound,
                                  medianTimeOf_s(runs, baseline, run.guess)));
  }
  return table;
}

std::string dumpHeader()
{
  return "id,matcher,guess,status,x_m,y_m,phi_deg,sigma_x_m,sigma_y_m,sigma_phi_deg,error_m,"
         "error_deg,time_ms\n";
}

std::string dumpRows(const PairsRun& run)
{
  std::string text;
  for (const auto& record : run.records)
  {
    const Pose2& pose = record.result.T_ref_cur;
    const auto sigma = [&record](int i) { return std::sqrt(record.result.covariance(i, i)); };
    text += std::to_string(record.id) + ',' + run.matcher + ',' + run.guess + ',' +
            toString(record.result.status);
    for (const double value :
         {pose.x_m, pose.y_m, radToDeg(pose.phi_rad), sigma(0), sigma(1), radToDeg(sigma(2)),
          record.error().translation_m, radToDeg(record.error().rotation_rad),
          kMillisecondsPerSecond * record.time_s})
      text += ',' + csvNumber(value);
    text += '\n';
  }
  return text;
}
}  // namespace psmks
