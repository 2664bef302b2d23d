/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/joint/CorrelativeSearch.h>
#include <psmks/joint/JointOptions.h>
#include <psmks/joint/LineVotes.h>
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
/** The memory of joint matches, kept from one to the next so that it is not allocated anew. */
struct JointBuffers
{
  ScanFeatures reference, current;
  LineVotes lineVotes;
  CorrelativeSearch correlativeSearch;
  std::vector<Hypothesis> hypotheses;
  std::vector<RefinedPose> refinedPoses;
  std::vector<RefinedPose> alternatives;
  JointProblem problem;
};

/** What the steps of one joint match share: what is asked, the buffers, and the result as far as it
 * is known. Steps add their iterations and times to the result. */
struct JointMatch
{
  /** All arguments are kept by reference; the features in the buffers are those of the scans.
   *  @param external null unless options.solver is Ceres
   *  @param trace may be null */
  JointMatch(const Guess& guess, const JointOptions& options, const ExternalSolvers* external,
             JointBuffers& buffers, MatchTrace* trace);

  const Guess& guess;
  const JointOptions& options;
  const ExternalSolvers* external;
  JointBuffers& buffers;
  MatchTrace* trace;

  double rangeSigma_m;  //!< of the noisier scan
  ScanScores scores;    //!< of poses for these scans
  MatchResult result;

  /** The guess as a measurement; null where it has no covariance or was given up. */
  const PriorTerm* prior() const
  {
    return guessPrior_ && !result.guessGivenUp ? &*guessPrior_ : nullptr;
  }

  /** Of the guess where it is used as a measurement, else MatchResult::unknownCovariance(). */
  Eigen::Matrix3d guessCovariance() const
  {
    return prior() ? *guess.covariance : MatchResult::unknownCovariance();
  }

  /** Logarithm of the density of the prior at a pose, relative to that at the guess. */
  double logPrior(const RefinedPose& pose) const;

  /** Standard deviation above which the position along a direction is weakly observable: that of
   * the options, or 1.5 standard deviations of a range where that is more. All rays together then
   * know less than half of what a single ray knows that meets a wall head-on. */
  double weakDirectionSigma_m() const
  {
    /** Standard deviation of the position above which it is weakly observable. Unit: standard
     *  deviations of a range. Evidence: measured.
     */
    constexpr double kHalfARay = 1.5;
    return std::max(options.weakDirectionSigma_m, kHalfARay * rangeSigma_m);
  }

  /** Standard deviation above which the position along a direction is not observable, and is taken
   * from the guess. */
  double unobservableSigma_m() const
  {
    return std::max(options.unobservableSigma_m, weakDirectionSigma_m());
  }

  /** Whether a pose associates more than this share of the current scan's rays, returns or not. */
  bool pairsMoreThan(double share, const RefinedPose& pose) const
  {
    return pose.associations > share * buffers.current.scan->rays();
  }

 private:
  std::optional<PriorTerm> guessPrior_;
};
}  // namespace psmks
