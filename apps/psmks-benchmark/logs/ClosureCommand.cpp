/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/logs/ClosureCommand.h>
#include <apps/support/Progress.h>
#include <apps/support/StopSignal.h>
#include <psmks/eval/Closure.h>
#include <psmks/eval/Statistics.h>

#include <algorithm>

namespace psmks
{
namespace
{
/** The motion of the sensor between two scans of a log by its odometry; none counts as no motion.
 */
Pose2 odometryBetween(const Log& log, std::size_t from, std::size_t to)
{
  Pose2 motion;
  for (std::size_t s = from + 1; s <= to; ++s)
    motion = motion * log.scans[s].odometry.value_or(Pose2());
  return log.scans[from].T_robot_sensor.inverse() * motion * log.scans[to].T_robot_sensor;
}

std::vector<Table::Column> columns()
{
  return {{"scans apart", "scans_apart", 0},   {"triangles", "triangles", 0},
          {"left out", "left_out", 0},         {"median mm", "translation_median_mm", 1},
          {"p95 mm", "translation_p95_mm", 1}, {"median deg", "rotation_median_deg", 3},
          {"p95 deg", "rotation_p95_deg", 3},  {"NEES", "nees", 2},
          {"median NEES", "nees_median", 2},   {"missing mm", "missing_mm", 2},
          {"missing deg", "missing_deg", 3}};
}

std::vector<Table::Cell> row(int apart, int leftOut, int draws,
                             const std::vector<Closure>& closures,
                             const std::vector<double>& squares)
{
  std::vector<double> translations_mm, rotations_deg;
  for (const Closure& closure : closures)
  {
    translations_mm.push_back(1e3 * closure.error.head<2>().norm());
    rotations_deg.push_back(radToDeg(std::abs(closure.error.z())));
  }
  constexpr double kP95 = 0.95;
  const MissingSigma missing = missingSigma(closures, draws);
  return {static_cast<double>(apart),
          static_cast<double>(closures.size()),
          static_cast<double>(leftOut),
          median(translations_mm),
          quantile(translations_mm, kP95),
          median(rotations_deg),
          quantile(rotations_deg, kP95),
          mean(squares),
          median(squares),
          1e3 * missing.sigma_m,
          radToDeg(missing.sigma_rad)};
}
}  // namespace

ClosureCommand::ClosureCommand(CLI::App& app)
{
  input_.addLogFlags(app);
  app.add_option("--apart", apart_, "scans from a to b, and from b to c")
      ->delimiter(',')
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--most", most_, "triangles, spread evenly over the log")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--draws", draws_, "closures with more noise for each covariance")
      ->check(CLI::Range(ClosureExperiment::kFewestDraws, 10000))
      ->capture_default_str();
  app.add_option("--seed", seed_, "of that noise")->capture_default_str();
  optionFlags_.addTo(app);
  output_.addFlags(app);
}

ExitCode ClosureCommand::run()
{
  const SlamOptions options = optionFlags_.options();
  output_.check();
  std::vector<Table> tables;
  for (const Log& log : input_.read(options.matching))
    if (!isToStop()) tables.push_back(closures(log, options.matching.matcher));
  if (!tables.empty()) output_.write(tables);
  if (input_.isDamaged()) return kInputDamaged;
  return tables.empty() ? kNothingToDo : kOk;
}

Table ClosureCommand::closures(const Log& log, const MatcherOptions& options) const
{
  Table table{log.title, columns(), {}};
  Progress progress(log.title);
  for (const int apart : apart_)
  {
    ClosureExperiment experiment(options, draws_, seed_);
    const auto leg = static_cast<std::size_t>(apart);
    const auto most = static_cast<std::size_t>(most_);
    const std::size_t fit = log.scans.size() > 2 * leg ? log.scans.size() - 2 * leg : 0;
    const std::size_t step = std::max(2 * leg, (fit + most - 1) / most);
    std::vector<Closure> closures;
    std::vector<double> squares;
    int leftOut = 0;
    for (std::size_t a = 0; a < fit; a += step)
    {
      const std::size_t b = a + leg, c = b + leg;
      const auto closure = experiment.close(log.scans[a].scan, log.scans[b].scan, log.scans[c].scan,
                                            odometryBetween(log, a, b), odometryBetween(log, b, c));
      progress.show(static_cast<double>(a) / static_cast<double>(fit));
      if (!closure)
      {
        ++leftOut;
        continue;
      }
      closures.push_back(*closure);
      squares.push_back(experiment.normalizedSquare(*closure));
    }
    table.rows.push_back(row(apart, leftOut, draws_, closures, squares));
  }
  return table;
}
}  // namespace psmks
