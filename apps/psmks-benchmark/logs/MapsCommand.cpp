/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/logs/MapAlignment.h>
#include <apps/psmks-benchmark/logs/MapsCommand.h>
#include <apps/support/Progress.h>
#include <apps/support/Summary.h>
#include <mrpt/slam/CICP.h>
#include <psmks/mrpt/ScanMatcher.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace psmks
{
namespace
{
using Algorithm =
    std::pair<std::string, std::shared_ptr<mrpt::slam::CMetricMapsAlignmentAlgorithm>>;

/** What is compared on a log: psmks told of the place of the scanner on the robot and without it,
 * and MRPT's ICP with the parameters of its icp-slam. */
std::vector<Algorithm> algorithmsFor(const Log& log, const ScanMatcherOptions& options)
{
  auto told = std::make_shared<ScanMatcher>(), untold = std::make_shared<ScanMatcher>();
  told->options = untold->options = options;
  told->options.view.T_map_sensor = log.scans.front().T_robot_sensor;
  for (const auto& matcher : {told, untold}) matcher->setMinLoggingLevel(mrpt::system::LVL_ERROR);
  auto icp = std::make_shared<mrpt::slam::CICP>();
  icp->options.maxIterations = 80;
  icp->options.thresholdDist = 0.3;
  icp->options.thresholdAng = degToRad(5);
  icp->options.ALFA = 0.8;
  icp->options.smallestThresholdDist = 0.05;
  return {{"psmks told", told}, {"psmks", untold}, {"icp-classic", icp}};
}

std::vector<Table::Column> columns()
{
  return {{"aligned by", "aligned_by"},
          {"alignments", "alignments", 0},
          {"refused", "refused", 0},
          {"refused %", "refused_percent", 2},
          {"moved > 0.5 m", "moved", 0},
          {"occupied cells", "occupied_cells", 0},
          {"mean error m", "error_mean_m", 3},
          {"max error m", "error_max_m", 3},
          {"ms an alignment", "alignment_ms", 2}};
}

std::vector<Table::Cell> row(const std::string& name, const MapAlignment& alignment,
                             const std::optional<Trajectory>& groundTruth)
{
  constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();
  const double alignments = alignment.alignments;
  const Summary summary = summarise(alignment.scans, groundTruth);
  return {name,
          alignments,
          static_cast<double>(alignment.refused),
          100 * alignment.refused / std::max(1.0, alignments),
          static_cast<double>(alignment.moved),
          static_cast<double>(summary.occupiedCells),
          summary.error ? summary.error->mean_m : kNoValue,
          summary.error ? summary.error->max_m : kNoValue,
          1e3 * alignment.alignment_s / std::max(1.0, alignments)};
}
}  // namespace

MapsCommand::MapsCommand(CLI::App& app)
{
  input_.addLogFlags(app);
  input_.addGroundTruthFlag(app);
  app.add_option("--insert-distance_m", insertDistance_m_,
                 "a scan is added to the map once the robot has moved so far")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--insert-angle_deg", insertAngle_deg_, "or has turned so far")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  optionFlags_.addTo(app);
  output_.addFlags(app);
}

ExitCode MapsCommand::run()
{
  const SlamOptions options = optionFlags_.options();
  input_.check();
  output_.check();
  std::vector<Table> tables;
  for (const Log& log : input_.read(options.matching))
  {
    Table table{log.title, columns(), {}};
    Progress progress(log.title);
    const auto algorithms = algorithmsFor(log, options.matching);
    for (std::size_t a = 0; a < algorithms.size(); ++a)
    {
      const auto& [name, algorithm] = algorithms[a];
      const MapGrowth growth{insertDistance_m_, degToRad(insertAngle_deg_)};
      table.rows.push_back(
          row(name, followByMap(log.scans, *algorithm, growth, options.odometry), log.groundTruth));
      progress.show(static_cast<double>(a + 1) / static_cast<double>(algorithms.size()));
    }
    tables.push_back(std::move(table));
  }
  if (!tables.empty()) output_.write(tables);
  if (input_.isDamaged()) return kInputDamaged;
  return tables.empty() ? kNothingToDo : kOk;
}
}  // namespace psmks
