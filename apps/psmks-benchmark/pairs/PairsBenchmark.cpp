/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/pairs/PairsBenchmark.h>
#include <apps/support/StopSignal.h>
#include <psmks/base/Stopwatch.h>
#include <psmks/matchers/PairMatcher.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace psmks
{
namespace
{
/** The runs of all matchers with one kind of guess. */
class GuessRuns
{
 public:
  GuessRuns(const std::vector<ScanPair>& pairs, const Guesses& guesses,
            const PairsBenchmarkOptions& options)
      : pairs_(pairs),
        guesses_(guesses.ofPair),
        sequential_(options.sequential),
        ofOneScanner_(options.ofOneScanner)
  {
    for (const auto& name : options.matchers)
    {
      matchers_.push_back(makePairMatcher(name, options.matcherOptions));
      scanners_.emplace_back();
      runs_.push_back({name, guesses.name, {}});
    }
  }

  void prepare()
  {
    for (std::size_t m = 0; m < matchers_.size(); ++m)
    {
      if (!pairs_.empty()) matchRaw(m, 0);
      for (std::size_t p = 0; p < pairs_.size(); ++p) runs_[m].records.push_back(unmatched(p));
    }
  }

  void match(std::size_t p)
  {
    for (std::size_t m = 0; m < matchers_.size(); ++m)
    {
      PairRecord& record = runs_[m].records[p];
      Stopwatch stopwatch;
      record.result = matchRaw(m, p);
      record.time_s = std::min(record.time_s, stopwatch.lap_s());
      if (sequential_)
        record.sequentialTime_s = std::fmin(record.sequentialTime_s, sequentialTime_s(m, p));
    }
  }

  const std::vector<PairsRun>& runs() const { return runs_; }

 private:
  PairRecord unmatched(std::size_t p) const
  {
    PairRecord record;
    record.id = pairs_[p].id;
    record.T_ref_cur_true = pairs_[p].T_ref_cur_true;
    record.T_ref_cur_guess = guesses_[p].T_ref_cur;
    record.time_s = std::numeric_limits<double>::infinity();
    record.sequentialTime_s = std::numeric_limits<double>::quiet_NaN();
    return record;
  }

  MatchResult matchRaw(std::size_t m, std::size_t p)
  {
    const ScanPair& pair = pairs_[p];
    PairMatcher& matcher = *matchers_[m];
    if (!ofOneScanner_) return matcher.match(pair.reference, pair.current, guesses_[p]);
    ScannerNoise& scanner = scanners_[m];
    const auto reference = matcher.prepare(pair.reference, scanner);
    const auto current = matcher.prepare(pair.current, scanner);
    scanner.add(current->showsMoreNoise());
    return matcher.matchPrepared(*reference, *current, guesses_[p]);
  }

  double sequentialTime_s(std::size_t m, std::size_t p)
  {
    PairMatcher& matcher = *matchers_[m];
    const auto reference = matcher.prepare(pairs_[p].reference, scanners_[m]);
    Stopwatch stopwatch;
    const auto current = matcher.prepare(pairs_[p].current, scanners_[m]);
    matcher.matchPrepared(*reference, *current, guesses_[p]);
    return stopwatch.lap_s();
  }

  const std::vector<ScanPair>& pairs_;
  const std::vector<Guess>& guesses_;
  bool sequential_, ofOneScanner_;
  std::vector<std::unique_ptr<PairMatcher>> matchers_;
  std::vector<ScannerNoise> scanners_;  //!< what each matcher has learnt, where the scanner is one
  std::vector<PairsRun> runs_;
};
}  // namespace

std::vector<PairsRun> runPairs(const std::vector<ScanPair>& pairs,
                               const std::vector<Guesses>& guesses,
                               const PairsBenchmarkOptions& options,
                               const std::function<void(double)>& progress)
{
  std::vector<GuessRuns> runsOfGuess;
  for (const Guesses& kind : guesses) runsOfGuess.emplace_back(pairs, kind, options).prepare();

  const auto total = static_cast<double>(pairs.size() * guesses.size()) * options.repeats;
  int done = 0;
  for (int repeat = 0; repeat < options.repeats; ++repeat)
    for (auto& runs : runsOfGuess)
      for (std::size_t p = 0; p < pairs.size(); ++p)
      {
        if (isToStop()) return {};
        runs.match(p);
        progress(++done / total);
      }

  std::vector<PairsRun> all;
  for (const auto& runs : runsOfGuess)
    all.insert(all.end(), runs.runs().begin(), runs.runs().end());
  return all;
}
}  // namespace psmks
