/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/pairs/MapPairsCommand.h>
#include <apps/support/Progress.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/slam/CICP.h>
#include <psmks/base/Stopwatch.h>
#include <psmks/eval/PairError.h>
#include <psmks/logs/RawlogWriter.h>
#include <psmks/mrpt/Convert.h>
#include <psmks/mrpt/ScanMatcher.h>

#include <algorithm>
#include <exception>
#include <limits>
#include <memory>

namespace psmks
{
namespace
{
using mrpt::maps::CMetricMap;
using mrpt::slam::CICP;
using mrpt::slam::CMetricMapsAlignmentAlgorithm;

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

/** How the two scans of a pair become maps. */
enum class Kind
{
  Points,
  GridAndPoints,
  Grids
};

struct Maps
{
  std::shared_ptr<CMetricMap> reference, current;
};

struct Alignments
{
  int pairs = 0, refused = 0, wrong = 0;
  std::vector<double> errors_m;
  double rotations_rad = 0, nees = 0, time_s = 0;
};

std::shared_ptr<CMetricMap> points(const Scan& scan)
{
  auto map = std::make_shared<mrpt::maps::CSimplePointsMap>();
  map->insertObservation(*toMrpt(scan, Pose2()));
  return map;
}

std::shared_ptr<CMetricMap> grid(const Scan& scan, double cell_m, double certainty)
{
  constexpr float kHalf_m = 1;  // grows as it is filled
  auto map = std::make_shared<mrpt::maps::COccupancyGridMap2D>(-kHalf_m, kHalf_m, -kHalf_m, kHalf_m,
                                                               static_cast<float>(cell_m));
  map->insertionOptions.maxOccupancyUpdateCertainty = static_cast<float>(certainty);
  map->insertObservation(*toMrpt(scan, Pose2()));
  return map;
}

/** Aligns the maps of a pair and counts how it ended. An algorithm that cannot align maps of this
 * kind, as MRPT's ICP two grids, refuses all. */
void align(CMetricMapsAlignmentAlgorithm& algorithm, const Maps& maps, const ScanPair& pair,
           Alignments& result)
{
  /** The threshold of MRPT's map builders. Unit: goodness. Definition: MRPT's default. */
  constexpr double kAccepted = 0.4;
  ++result.pairs;
  CICP::TReturnInfo info;
  mrpt::poses::CPosePDFGaussian found;
  Stopwatch watch;
  try
  {
    const mrpt::poses::CPosePDFGaussian guess(toMrpt(pair.T_ref_cur_odometry));
    found.copyFrom(*algorithm.AlignPDF(maps.reference.get(), maps.current.get(), guess, info));
  }
  catch (const std::exception&)
  {
    info.goodness = 0;
  }
  result.time_s += watch.lap_s();
  if (info.goodness <= kAccepted)
  {
    ++result.refused;
    return;
  }
  const UncertainPose estimate = toUncertainPose(found);
  const PairError error = pairError(estimate.pose, pair.T_ref_cur_true);
  result.wrong += isAcceptedAndWrong(MatchStatus::Converged, error) ? 1 : 0;
  result.errors_m.push_back(error.translation_m);
  result.rotations_rad += error.rotation_rad;
  result.nees += nees(estimate.pose, estimate.covariance, pair.T_ref_cur_true);
}

double median(std::vector<double> values)
{
  if (values.empty()) return kNoValue;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::vector<Table::Cell> row(const std::string& kind, const std::string& name,
                             const Alignments& alignments)
{
  const double accepted = alignments.pairs - alignments.refused;
  return {kind,
          name,
          static_cast<double>(alignments.pairs),
          static_cast<double>(alignments.refused),
          static_cast<double>(alignments.wrong),
          1e3 * median(alignments.errors_m),
          accepted > 0 ? radToDeg(alignments.rotations_rad) / accepted : kNoValue,
          accepted > 0 ? alignments.nees / accepted : kNoValue,
          1e3 * alignments.time_s / std::max(1, alignments.pairs)};
}

const std::vector<Table::Column> kColumns{{"maps", "maps"},
                                          {"aligned by", "aligned_by"},
                                          {"pairs", "pairs", 0},
                                          {"refused", "refused", 0},
                                          {"wrong", "wrong", 0},
                                          {"median error mm", "error_median_mm", 2},
                                          {"mean deg", "error_mean_deg", 3},
                                          {"NEES", "nees", 1},
                                          {"ms an alignment", "alignment_ms", 2}};
}  // namespace

MapPairsCommand::MapPairsCommand(CLI::App& app)
{
  app.add_option("SET", sets_, "files of scan pairs (.pairs or .pairs.gz), or names of sets")
      ->required();
  addChoiceFlags(app, choice_);
  app.add_option("--cell_m", cell_m_, "side of a cell")
      ->check(CLI::Range(0.01, 1.0))
      ->capture_default_str();
  app.add_option("--certainty", certainty_,
                 "maxOccupancyUpdateCertainty of the grids; MRPT's ini files have 0.54")
      ->check(CLI::Range(0.51, 0.99))
      ->capture_default_str();
  optionFlags_.addTo(app);
  output_.addFlags(app);
}

ExitCode MapPairsCommand::run()
{
  const ScanMatcherOptions options = optionFlags_.options().matching;
  output_.check();
  std::vector<Table> tables;
  bool isDamaged = false;
  for (const std::string& set : sets_)
  {
    const PairsInput input = inputPairs(set, choice_);
    isDamaged = isDamaged || input.isDamaged;
    if (!input.pairs.empty()) tables.push_back(tableOf(input, options));
  }
  if (!tables.empty()) output_.write(tables);
  if (isDamaged) return kInputDamaged;
  return tables.empty() ? kNothingToDo : kOk;
}

Table MapPairsCommand::tableOf(const PairsInput& input, const ScanMatcherOptions& options) const
{
  Table table{input.title, kColumns, {}};
  ScanMatcher psmks(options);
  psmks.setMinLoggingLevel(mrpt::system::LVL_ERROR);
  CICP icp;
  Progress progress(input.title);
  const std::vector<std::pair<Kind, std::string>> kinds{{Kind::Points, "points to points"},
                                                        {Kind::GridAndPoints, "points to grid"},
                                                        {Kind::Grids, "grid to grid"}};
  for (const auto& [kind, name] : kinds)
  {
    Alignments ofPsmks, ofIcp;
    for (const ScanPair& pair : input.pairs)
    {
      const bool isReferencePoints = kind == Kind::Points, isCurrentPoints = kind != Kind::Grids;
      const Maps maps{
          isReferencePoints ? points(pair.reference) : grid(pair.reference, cell_m_, certainty_),
          isCurrentPoints ? points(pair.current) : grid(pair.current, cell_m_, certainty_)};
      align(psmks, maps, pair, ofPsmks);
      align(icp, maps, pair, ofIcp);
      progress.show(static_cast<double>(ofIcp.pairs) / static_cast<double>(input.pairs.size()));
    }
    table.rows.push_back(row(name, "psmks", ofPsmks));
    table.rows.push_back(row(name, "icp", ofIcp));
  }
  return table;
}
}  // namespace psmks
