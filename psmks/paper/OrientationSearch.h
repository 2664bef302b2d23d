/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/match/MatchTrace.h>
#include <psmks/paper/PoseObjective.h>

namespace psmks
{
/** The result of an orientation search. */
struct OrientationMinimum
{
  bool found = false;  //!< whether some orientation has enough associated rays
  double phi_rad = 0;  //!< the orientation found, or the start if none was found
  PoseObjective::Value value;
};

/** Finds the orientation with the smallest matching error at a fixed translation by trying all of
 * them (paper, section 2.3): a coarse stage over start +- coarseRange_rad, then a fine stage over
 * the minimum of the first +- fineRange_rad. Orientations do not count if they have fewer
 * associations than minAssociations, or fewer than minAssociationShare times the largest number of
 * associations in the stage.
 *  @param trace if not null, gets the error curve of each stage */
OrientationMinimum searchOrientation(PoseObjective& objective, const Pose2& start,
                                     MatchTrace* trace);
}  // namespace psmks
