/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/joint/JointMatch.h>
#include <psmks/match/SearchScope.h>
#include <psmks/segmentation/SegmentedScan.h>

namespace psmks
{
/** Matches two scans by the joint scheme (docs/derivations.md, "Search").
 *
 *  1. The guess is refined where its rough score is promising (Refinement::refine()): lines and
 *     single rays are associated and Gauss-Newton solves for x, y and phi, in turn, with gates that
 *     narrow.
 *  2. Where no pose is convincing (PoseVerifier), the poses that lines vote for are refined, then
 *     the optima of a window about the guess (CandidateSearch::followVotes(), searchNear()).
 *  3. Where the best pose is doubtful and the scope is Full, the optima of a wide window are
 * refined (CandidateSearch::searchWide()).
 *  4. The likeliest pose is accepted if its score is high enough, and JointConclusion settles what
 *     the scans leave open, the covariance, and whether the guess is contradicted.
 *
 *  Bad data never throws; MatchResult states what a result promises. Both scans have at least one
 *  valid ray, the guess is finite, and its covariance, if any, is positive definite: Matcher sees
 *  to it.
 *
 *  @param scope NearGuess leaves out the wide window of step 3
 *  @param external null unless options.solver is Ceres
 *  @param trace may be null */
MatchResult matchByJointScheme(const SegmentedScan& reference, const SegmentedScan& current,
                               const Guess& guess, SearchScope scope, const JointOptions& options,
                               const ExternalSolvers* external, JointBuffers& buffers,
                               MatchTrace* trace);
}  // namespace psmks
