/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/PairsBenchmark.h>
#include <psmks/core/Stopwatch.h>
#include <psmks/mrpt/PairMatcher.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace psmks
{
namespace
{
/** The runs of all matchers from one kind of guess. */
class GuessRuns
{
 public:
  GuessRuns(GuessKind kind, const PairsBenchmarkOptions& options) : kind_(kind), options_(options)
  {
    for (const auto& name : options.matchers)
    {
      matchers_.push_back(makePairMatcher(name, options.matcherOptions));
      runs_.push_back({name, toString(kind), {}});
    }
  }

  void prepare(const std::vector<ScanPair>& pairs)
  {
    for (std::size_t m = 0; m < matchers_.size(); ++m)
    {
      if (!pairs.empty()) match(m, pairs.front());
      for (const auto& pair : pairs) runs_[m].records.push_back(unmatched(pair));
    }
  }

  void match(const std::vector<ScanPair>& pairs, std::size_t p)
  {
    for (std::size_t m = 0; m < matchers_.size(); ++m)
    {
      PairRecord& record = runs_[m].records[p];
      Stopwatch stopwatch;
      record.result = match(m, pairs[p]);
      record.time_s = std::min(record.time_s, stopwatch.lap_s());
      if (options_.sequential)
        record.sequentialTime_s = std::fmin(record.sequentialTime_s, sequentialTime_s(m, pairs[p]));
    }
  }

  const std::vector<PairsRun>& runs() const { return runs_; }

 private:
  PairRecord unmatched(const ScanPair& pair) const
  {
    PairRecord record;
    record.id = pair.id;
    record.T_ref_cur_true = pair.T_ref_cur_true;
    record.T_ref_cur_guess = guess(pair).T_ref_cur;
    record.time_s = std::numeric_limits<double>::infinity();
    record.sequentialTime_s = std::numeric_limits<double>::quiet_NaN();
    return record;
  }

  MatchResult match(std::size_t m, const ScanPair& pair)
  {
    return matchers_[m]->match(pair.reference, pair.current, guess(pair));
  }

  double sequentialTime_s(std::size_t m, const ScanPair& pair)
  {
    matchers_[m]->setReference(pair.reference);
    Stopwatch stopwatch;
    matchers_[m]->matchToReference(pair.current, guess(pair));
    return stopwatch.lap_s();
  }

  Guess guess(const ScanPair& pair) const
  {
    if (kind_ == GuessKind::Zero) return {};
    const Eigen::Array3d sigma(options_.odometrySigma_m, options_.odometrySigma_m,
                               options_.odometrySigma_rad);
    return {pair.T_ref_cur_odometry, Eigen::Matrix3d(sigma.square().matrix().asDiagonal())};
  }

  GuessKind kind_;
  const PairsBenchmarkOptions& options_;
  std::vector<std::unique_ptr<PairMatcher>> matchers_;
  std::vector<PairsRun> runs_;
};
}  // namespace

std::string toString(GuessKind kind) { return kind == GuessKind::Zero ? "zero" : "odometry"; }

std::vector<PairsRun> runPairs(const std::vector<ScanPair>& pairs,
                               const PairsBenchmarkOptions& options,
                               const std::function<void(double)>& progress)
{
  std::vector<GuessRuns> guesses;
  for (const GuessKind kind : options.guesses) guesses.emplace_back(kind, options).prepare(pairs);

  const auto total = static_cast<double>(pairs.size() * guesses.size()) * options.repeats;
  int done = 0;
  for (int repeat = 0; repeat < options.repeats; ++repeat)
    for (auto& runs : guesses)
      for (std::size_t p = 0; p < pairs.size(); ++p)
      {
        runs.match(pairs, p);
        progress(++done / total);
      }

  std::vector<PairsRun> all;
  for (const auto& runs : guesses) all.insert(all.end(), runs.runs().begin(), runs.runs().end());
  return all;
}
}  // namespace psmks
