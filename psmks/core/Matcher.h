/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/core/MatcherOptions.h>
#include <psmks/geometry/Scan.h>
#include <psmks/match/Guess.h>
#include <psmks/match/MatchResult.h>
#include <psmks/match/MatchTrace.h>
#include <psmks/match/SearchScope.h>
#include <psmks/segmentation/ScannerNoise.h>
#include <psmks/segmentation/SegmentedScan.h>

#include <memory>

namespace psmks
{
class ExternalSolvers;

/** The memory that a Matcher works in, kept from one match to the next so that a further match with
 * scans of the same size allocates nothing. It holds no state: what a match returns does not depend
 * on the matches before. One workspace serves one thread at a time; it may serve several matchers.
 */
class MatcherWorkspace
{
 public:
  MatcherWorkspace();
  ~MatcherWorkspace();
  MatcherWorkspace(MatcherWorkspace&&) noexcept;
  MatcherWorkspace& operator=(MatcherWorkspace&&) noexcept;

 private:
  friend class Matcher;
  struct Buffers;
  std::unique_ptr<Buffers> buffers_;
};

/** Estimates the motion between two scans on lines that a Kalman filter finds in them (PSM-KS), by
 * one of two schemes: Scheme::Joint, the default, is this project's own, and Scheme::Paper is that
 * of Cuadra Troncoso et al., 2015.
 *
 * Both begin with the lines:
 *
 * 1. segmentScan() in segmentation/: noise of the ranges, lines (LineGrowing), their fit (fitLine).
 *
 * The joint scheme, matchByJointScheme() in joint/JointScheme.cpp:
 *
 * 2. ScanFeatures::build() in features/ adds circles, short lines, surfels, depth edges, movable
 *    objects, and the surface that is seen at every bearing.
 * 3. Refinement::refine() in joint/ leads a start to a pose, first the guess if it scores well:
 *    associateFeatures() and solveByGaussNewton() take turns; logLikelihoodRatio() judges the end.
 * 4. Unless the pose convinces PoseVerifier in joint/, CandidateSearch there refines the poses that
 *    lines vote for (LineVotes), then the optima of a window about the guess (CorrelativeSearch).
 * 5. If it is doubtful, the optima of a wide window are refined, too.
 * 6. JointConclusion::conclude() in joint/ accepts or refuses, takes from the guess what the scans
 *    leave open, and settles covariance and ambiguity.
 *
 * The paper's scheme, matchByPaperScheme() in paper/PaperScheme.cpp, repeats from the guess on:
 *
 * 2. searchOrientation() in paper/ turns the current scan to where PoseObjective::evaluate() is
 *    best: projectScan(), associate(), matchingError().
 * 3. solveTranslation() in paper/ gives the step of the position by linear regression.
 * 4. In the end PaperCovariance in paper/ tells the covariance and what the scans leave open.
 *
 * A matcher is immutable: one may serve several threads at once, each with its own workspace. */
class Matcher
{
 public:
  /** @param externalSolvers needed where the options choose Ceres (psmks/ceres/CeresSolvers.h)
   *  @throws OptionError if MatcherOptions::validate() does, or if the options choose Ceres and no
   *  external solvers are given */
  explicit Matcher(MatcherOptions options = {},
                   std::shared_ptr<const ExternalSolvers> externalSolvers = nullptr);

  const MatcherOptions& options() const { return options_; }

  /** Segments a scan by these options, as match() needs it; see segmentScan(). A reference that
   * several scans are matched against needs it only once.
   *  @param result replaced; keeps its memory
   *  @param scanner what earlier scans told about the noise of the scanner */
  void segment(const Scan& scan, MatcherWorkspace& workspace, SegmentedScan& result,
               const ScannerNoise& scanner = {}) const;

  /** Estimates the pose of the current sensor frame in the frame of the reference sensor; see
   *  MatchResult. Bad data never throws but ends in a MatchStatus that is a failure.
   *  @param reference, current segmented by a matcher with the same options
   *  @param trace gets the steps appended where not null
   *  @param scope how far from the guess the joint scheme looks; the paper's scheme has but one */
  MatchResult match(const SegmentedScan& reference, const SegmentedScan& current,
                    const Guess& guess, MatcherWorkspace& workspace, MatchTrace* trace = nullptr,
                    SearchScope scope = SearchScope::Full) const;

  /** The same from raw scans: segments both, and adds the time of it to StageTimes::segmentation_s.
   */
  MatchResult match(const Scan& reference, const Scan& current, const Guess& guess,
                    MatcherWorkspace& workspace, MatchTrace* trace = nullptr,
                    SearchScope scope = SearchScope::Full) const;

 private:
  MatcherOptions options_;
  std::shared_ptr<const ExternalSolvers> externalSolvers_;
};
}  // namespace psmks
