/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/joint/CorrelativeSearch.h>
#include <psmks/joint/Hypotheses.h>
#include <psmks/joint/JointOptions.h>
#include <psmks/joint/RefinedPose.h>
#include <psmks/joint/ScanScores.h>
#include <psmks/match/ExternalSolvers.h>
#include <psmks/match/Guess.h>
#include <psmks/match/JointProblem.h>
#include <psmks/match/MatchResult.h>
#include <psmks/match/MatchTrace.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace psmks
{
/** The buffers of a joint match, kept from one to the next. */
struct JointBuffers
{
  ScanFeatures reference, current;
  HypothesisSearch search;
  CorrelativeSearch correlativeSearch;
  std::vector<Hypothesis> hypotheses;
  std::vector<RefinedPose> refinedPoses;
  JointProblem problem;
};

/** What the steps of one joint match share: what is asked, the buffers, and the result as far as it
 * is known. Steps add their iterations and times to the result as they go. */
struct JointMatch
{
  /** All arguments are kept by reference; the views of the buffers are those of the scans.
   *  @param external null unless options.solver is Ceres
   *  @param trace may be null */
  JointMatch(const Guess& guess, const JointOptions& options, const ExternalSolvers* external,
             JointBuffers& buffers, MatchTrace* trace);

  const Guess& guess;
  const JointOptions& options;
  const ExternalSolvers* external;
  JointBuffers& buffers;
  MatchTrace* trace;

  double rangeSigma_m;                  //!< of the noisier scan
  ScanScores scores;                    //!< of poses for these scans
  std::optional<PriorTerm> guessPrior;  //!< the guess, where it was measured and not given up
  MatchResult result;

  /** A direction in which the position is known worse is not observable: that of the options, or
   * for noisy scanners the one below which all rays together know less than half of a single ray
   * that meets a wall head-on. */
  double weakDirectionSigma_m() const
  {
    constexpr double kHalfARay = 1.5;
    return std::max(options.weakDirectionSigma_m, kHalfARay * rangeSigma_m);
  }

  /** Whether a pose associates more than this share of the current scan's rays. */
  bool pairsMoreThan(double share, const RefinedPose& pose) const
  {
    return pose.associations > share * buffers.current.scan->rays();
  }
};
}  // namespace psmks
