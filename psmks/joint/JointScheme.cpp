/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/joint/CandidateSearch.h>
#include <psmks/joint/JointConclusion.h>
#include <psmks/joint/JointScheme.h>

namespace psmks
{
namespace
{
/** Builds the features of both scans and drops the refined poses of the match before. */
void fill(JointBuffers& buffers, const SegmentedScan& reference, const SegmentedScan& current)
{
  buffers.refinedPoses.clear();
  buffers.reference.build(reference);
  buffers.current.build(current);
}

void tryGuess(JointMatch& match, CandidateSearch& search)
{
  /** Rough score from which on the guess is refined before anything is searched. Unit: score.
   * Evidence: measured. */
  constexpr double kPromising = 0.3;
  const Pose2& guess_T_ref_cur = match.guess.T_ref_cur;
  if (match.scores.roughScore(guess_T_ref_cur) >= kPromising) search.refineAndKeep(guess_T_ref_cur);
}
}  // namespace

MatchResult matchByJointScheme(const SegmentedScan& reference, const SegmentedScan& current,
                               const Guess& guess, SearchScope scope, const JointOptions& options,
                               const ExternalSolvers* external, JointBuffers& buffers,
                               MatchTrace* trace)
{
  fill(buffers, reference, current);
  JointMatch match(guess, options, external, buffers, trace);
  const PoseVerifier verifier(match);
  Refinement refinement(match);
  CandidateSearch search(match, verifier, refinement);
  const RefinedPose& best = search.best();
  const bool searchesWide = options.wideRadius_m > 0 && scope == SearchScope::Full;
  search.reserve();

  if (scope == SearchScope::WithinCovariance)
    search.searchWithinCovariance();
  else
  {
    tryGuess(match, search);
    if (!verifier.isConvincing(best)) search.followVotes();
    if (!verifier.isConvincing(best)) search.searchNear();
    if (searchesWide && verifier.isDoubtful(best)) search.searchWide();
  }
  JointConclusion(match, verifier, refinement, best).conclude(search.mostAssociations());
  return match.result;
}
}  // namespace psmks
