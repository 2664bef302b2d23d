/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/match/MatchTrace.h>
#include <psmks/paper/PoseObjective.h>

namespace psmks
{
/** Where the orientation search ended. */
struct OrientationMinimum
{
  bool found = false;  //!< some orientation had enough associated rays
  double phi_rad = 0;  //!< the start where none had
  PoseObjective::Value value;
};

/** Orientation by brute force at a fixed translation (paper, section 2.3): the smallest matching
 *  error over start +- coarseRange_rad, then over the minimum +- fineRange_rad. Orientations that
 *  associate fewer rays than minAssociations, or than minAssociationShare of the most that one of
 *  the stage associates, do not count.
 *  @param trace gets one curve per stage where not null */
OrientationMinimum searchOrientation(PoseObjective& objective, const Pose2& start,
                                     MatchTrace* trace);
}  // namespace psmks
