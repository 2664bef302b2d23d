/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/Guesses.h>
#include <apps/psmks-benchmark/convergence/Convergence.h>
#include <apps/support/StopSignal.h>
#include <psmks/eval/PairError.h>
#include <psmks/matchers/PairMatcher.h>

#include <memory>
#include <random>

namespace psmks
{
namespace
{
std::vector<double> evenly(double largest, int steps)
{
  const Eigen::VectorXd values = Eigen::VectorXd::LinSpaced(steps, 0, largest);
  return {values.begin(), values.end()};
}

bool succeeds(PairMatcher& matcher, const ScanPair& pair, const Guess& guess)
{
  const MatchResult result = matcher.match(pair.reference, pair.current, guess);
  return isSuccess(pairError(result.T_ref_cur, pair.T_ref_cur_true));
}
}  // namespace

ConvergenceGrid ConvergenceGrid::even(double maxDistance_m, double maxRotation_rad, int steps)
{
  return {evenly(maxDistance_m, steps), evenly(maxRotation_rad, steps)};
}

std::vector<ConvergenceMap> measureConvergence(const std::vector<ScanPair>& pairs,
                                               const ConvergenceOptions& options,
                                               const std::function<void(double)>& progress)
{
  const auto rows = static_cast<Eigen::Index>(options.grid.rotations_rad.size());
  const auto columns = static_cast<Eigen::Index>(options.grid.distances_m.size());
  std::vector<std::unique_ptr<PairMatcher>> matchers;
  std::vector<ConvergenceMap> maps;
  for (const std::string& name : options.matchers)
  {
    matchers.push_back(makePairMatcher(name, options.matcherOptions));
    maps.push_back({name, Eigen::MatrixXd::Zero(rows, columns)});
  }

  std::mt19937_64 random(options.seed);
  const double share = 1 / static_cast<double>(pairs.size());
  for (const ScanPair& pair : pairs)
  {
    if (isToStop()) return {};
    progress(share * static_cast<double>(&pair - pairs.data()));
    for (Eigen::Index r = 0; r < rows; ++r)
      for (Eigen::Index c = 0; c < columns; ++c)
      {
        const Guess guess = displacedGuess(
            pair.T_ref_cur_true, options.grid.distances_m[static_cast<std::size_t>(c)],
            options.grid.rotations_rad[static_cast<std::size_t>(r)], random);
        for (std::size_t m = 0; m < matchers.size(); ++m)
          if (succeeds(*matchers[m], pair, guess)) maps[m].successShare(r, c) += share;
      }
  }
  return maps;
}
}  // namespace psmks
