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
 *  2. Where no pose is convincing (PoseVerifier), the poses that segment angles and line
 *     intersections vote for are refined; if the guess has no covariance and still no pose is
 *     convincing, places along walls are, too (CandidateSearch::searchFurther()).
 *  3. Where the best pose is doubtful and the scope is Full, a grid of poses about the guess is
 *     scored and its best poses are refined (CandidateSearch::searchWide()).
 *  4. Where the guess has no covariance and the best pose is convincing, but held by few rays along
 *     some direction, starts beside it are refined (CandidateSearch::probeAlternatives()).
 *  5. The pose with the best score is accepted if that is high enough, and JointConclusion settles
 *     what the scans leave open, the covariance, and whether the guess is contradicted.
 *
 *  Bad data never throws; MatchResult states what a result promises. Both scans have at least one
 *  valid ray, the guess is finite, and its covariance, if any, is positive definite: Matcher sees
 *  to it.
 *
 *  @param scope NearGuess leaves out the grid of poses of step 3
 *  @param external null unless options.solver is Ceres
 *  @param trace may be null */
MatchResult matchByJointScheme(const SegmentedScan& reference, const SegmentedScan& current,
                               const Guess& guess, SearchScope scope, const JointOptions& options,
                               const ExternalSolvers* external, JointBuffers& buffers,
                               MatchTrace* trace);
}  // namespace psmks
