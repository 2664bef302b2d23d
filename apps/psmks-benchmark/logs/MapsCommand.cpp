/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/logs/MapAlignment.h>
#include <apps/psmks-benchmark/logs/MapsCommand.h>
#include <apps/support/Progress.h>
#include <mrpt/slam/CICP.h>
#include <psmks/eval/OccupiedCells.h>
#include <psmks/mrpt/ScanMatcher.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

namespace psmks
{
namespace
{
using Algorithm =
    std::pair<std::string, std::shared_ptr<mrpt::slam::CMetricMapsAlignmentAlgorithm>>;

/** What is compared on a log: psmks with the place of the scanner on the robot told and without it,
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
  return {{"psmks, scanner told", told}, {"psmks", untold}, {"icp-classic", icp}};
}

std::vector<Table::Column> columns()
{
  return {{"aligned by", "aligned_by"},
          {"alignments", "alignments", 0},
          {"refused", "refused", 0},
          {"refused %", "refused_percent", 2},
          {"moved > 0.5 m", "moved", 0},
          {"occupied cells", "occupied_cells", 0},
          {"ms an alignment", "alignment_ms", 2}};
}

std::vector<Table::Cell> row(const std::string& name, const MapAlignment& alignment)
{
  const double alignments = alignment.alignments;
  OccupiedCells cells;
  for (const PosedScan& scan : alignment.scans) cells.add(scan.scan, scan.T_world_sensor());
  return {name,
          alignments,
          static_cast<double>(alignment.refused),
          100 * alignment.refused / std::max(1.0, alignments),
          static_cast<double>(alignment.moved),
          static_cast<double>(cells.count()),
          1e3 * alignment.alignment_s / std::max(1.0, alignments)};
}
}  // namespace

MapsCommand::MapsCommand(CLI::App& app)
{
  input_.addLogFlags(app);
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
      table.rows.push_back(row(name, followByMap(log.scans, *algorithm, growth, options.odometry)));
      progress.show(static_cast<double>(a + 1) / static_cast<double>(algorithms.size()));
    }
    tables.push_back(std::move(table));
  }
  if (!tables.empty()) output_.write(tables);
  if (input_.isDamaged()) return kInputDamaged;
  return tables.empty() ? kNothingToDo : kOk;
}
}  // namespace psmks
