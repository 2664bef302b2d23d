/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/joint/JointMatch.h>
#include <psmks/match/SearchScope.h>
#include <psmks/segmentation/SegmentedScan.h>

namespace psmks
{
/** Matches two scans by the joint scheme (docs/derivations.md):
 *
 *  1. Refine the guess: associate lines and single rays, Gauss-Newton over x, y, theta, again with
 *     narrower gates.
 *  2. Score the result by free space. Where it is not convincing, let segment angles and line
 *     intersections vote for other starts and refine those, most promising first.
 *  3. Where the guess was not measured: try places along walls that leave the place open, search
 *     far from the guess where nothing near it holds, and put poses that few rays hold to the test.
 *  4. Accept the pose with the best score if that is high enough; find out what it and its
 *     rivals leave open.
 *
 * @param scope NearGuess leaves the search far from the guess out of step 3
 * @param external null unless options.solver is Ceres
 * @param trace may be null */
MatchResult matchByJointScheme(const SegmentedScan& reference, const SegmentedScan& current,
                               const Guess& guess, SearchScope scope, const JointOptions& options,
                               const ExternalSolvers* external, JointBuffers& buffers,
                               MatchTrace* trace);
}  // namespace psmks
