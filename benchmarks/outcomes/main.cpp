/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */

/** The evidence of the weights of logLikelihoodRatio(): how often each outcome of a look is met at
 * right poses and at the best wrong pose of the same pair, and how often the best pose of a pair is
 * right, by its score. */

#include <psmks/core/Matcher.h>
#include <psmks/eval/PairsFile.h>
#include <psmks/joint/Refinement.h>
#include <psmks/sim/PairSets.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

namespace psmks
{
namespace
{
/** Number of outcomes of a look, and their names. */
constexpr int kOutcomes = 6;
constexpr std::array<const char*, kOutcomes> kNames{"on",    "front",     "behind",
                                                    "moved", "uncovered", "unknown"};

/** Number of equal ranges of the score. */
constexpr int kRanges = 10;

using Shares = std::array<double, kOutcomes>;

Shares sharesOf(const RayCounts& n)
{
  const double looks = std::max(1.0f, n.looks());
  return {n.on / looks,    n.front / looks,     n.behind / looks,
          n.moved / looks, n.uncovered / looks, n.unknown / looks};
}

/** A refined pose of a pair, with the looks at it. */
struct Candidate
{
  double score;
  Shares shares;
};

/** What all pairs of a set, or of all sets, add up to. */
struct Sums
{
  Shares right{}, wrong{};
  int rights = 0, wrongs = 0;
  std::array<int, kRanges> best{}, bestRight{};

  void add(const std::optional<Candidate>& rightPose, const std::optional<Candidate>& wrongPose)
  {
    if (rightPose) accumulate(*rightPose, right, rights);
    if (wrongPose) accumulate(*wrongPose, wrong, wrongs);
    if (!rightPose && !wrongPose) return;
    const bool isRight = rightPose && (!wrongPose || rightPose->score >= wrongPose->score);
    const double score = isRight ? rightPose->score : wrongPose->score;
    const auto range =
        static_cast<std::size_t>(std::clamp(static_cast<int>(score * kRanges), 0, kRanges - 1));
    ++best[range];
    bestRight[range] += isRight;
  }

 private:
  static void accumulate(const Candidate& candidate, Shares& sum, int& count)
  {
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += candidate.shares[i];
    ++count;
  }
};

void keepBetter(const Candidate& candidate, std::optional<Candidate>& best)
{
  if (!best || candidate.score > best->score) best = candidate;
}

/** Refines the truth and the optima of a search two metres and 90 degrees about it, and adds the
 * best right and the best wrong pose whose positions the scans fix. Poses between right and wrong
 * count as neither. */
void addPair(const Scan& referenceScan, const Scan& currentScan, const Pose2& T_true, Sums& sums)
{
  constexpr double kRight_m = 0.1, kWrong_m = 0.2, kRight_rad = degToRad(2),
                   kWrong_rad = degToRad(4);
  constexpr std::size_t kOptima = 24;
  const Matcher matcher;
  MatcherWorkspace workspace;
  SegmentedScan reference, current;
  matcher.segment(referenceScan, workspace, reference);
  matcher.segment(currentScan, workspace, current);
  JointBuffers buffers;
  buffers.reference.build(reference);
  buffers.current.build(current);
  const Guess guess;
  const JointOptions options;
  JointMatch match(guess, options, nullptr, buffers, nullptr);
  Refinement refinement(match);
  std::vector<Hypothesis> starts;
  buffers.correlativeSearch.propose(buffers.reference, buffers.current, {}, {2, degToRad(90)},
                                    match.scores.tolerance_m(), kOptima, starts);
  starts.push_back({T_true, 0});
  std::optional<Candidate> right, wrong;
  for (const Hypothesis& start : starts)
  {
    const RefinedPose pose = refinement.refine(start.T_ref_cur);
    if (pose.score < 0 || pose.observability.weakSigma_m > options.unobservableSigma_m) continue;
    const Pose2 error = T_true.inverse() * pose.T_ref_cur;
    const double off_m = error.translation().norm(), off_rad = std::abs(error.phi_rad);
    const Candidate candidate{pose.score, sharesOf(match.scores.allCounts(pose.T_ref_cur))};
    if (off_m < kRight_m && off_rad < kRight_rad) keepBetter(candidate, right);
    if (off_m > kWrong_m || off_rad > kWrong_rad) keepBetter(candidate, wrong);
  }
  sums.add(right, wrong);
}

Sums ofInput(const std::string& input)
{
  constexpr unsigned kSeed = 31;
  constexpr int kPairs = 300;
  Sums sums;
  if (const PairFamily* family = findPairFamily(input))
  {
    for (const SimulatedPair& pair : makePairSet(*family, kSeed, kPairs).pairs)
      addPair(pair.reference.scan, pair.current.scan, pair.T_ref_cur_true, sums);
    return sums;
  }
  PairsReader reader(input);
  for (ScanPair pair; reader.read(pair);)
    addPair(pair.reference, pair.current, pair.T_ref_cur_true, sums);
  return sums;
}

/** The mean over the inputs, each with the same weight. */
void print(const std::vector<Sums>& inputs)
{
  std::cout << "outcome    right %  best wrong %  ln(right / wrong)\n";
  for (std::size_t i = 0; i < kNames.size(); ++i)
  {
    double right = 0, wrong = 0;
    for (const Sums& sums : inputs)
    {
      right += sums.right[i] / std::max(1, sums.rights) / static_cast<double>(inputs.size());
      wrong += sums.wrong[i] / std::max(1, sums.wrongs) / static_cast<double>(inputs.size());
    }
    std::printf("%-10s %7.1f %13.1f %18.2f\n", kNames[i], 100 * right, 100 * wrong,
                std::log(right / wrong));
  }
  std::cout << "\nscore of the best pose   pairs   right %\n";
  for (std::size_t range = 0; range < kRanges; ++range)
  {
    int pairs = 0, right = 0;
    for (const Sums& sums : inputs) pairs += sums.best[range], right += sums.bestRight[range];
    std::printf("%.1f to %.1f %20d %9.1f\n", static_cast<double>(range) / kRanges,
                static_cast<double>(range + 1) / kRanges, pairs,
                100.0 * right / std::max(1, pairs));
  }
}
}  // namespace
}  // namespace psmks

int main(int argc, char** argv)
{
  if (argc < 2)
  {
    std::cerr << "usage: psmks_outcomes SET|FILE.pairs[.gz]...   names of sets: psmks-benchmark "
                 "pairs --list-sets\n";
    return 1;
  }
  std::vector<psmks::Sums> inputs;
  try
  {
    for (int i = 1; i < argc; ++i) inputs.push_back(psmks::ofInput(argv[i]));
  }
  catch (const psmks::PairsFileError& error)
  {
    std::cerr << "psmks_outcomes: " << error.what() << "\n";
    return 2;
  }
  psmks::print(inputs);
  return 0;
}
