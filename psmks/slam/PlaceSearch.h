/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/slam/PosedScan.h>
#include <psmks/slam/ReferencePolicy.h>

namespace psmks
{
/** A pose, and how much two scans share if it is right. */
struct SharedPlace
{
  Pose2 T_ref_cur;     //!< the robot at the current scan, seen from the robot at the reference
  double overlap = 0;  //!< of the current scan by the reference, see Overlap
};

/** Searches for the pose at which two scans share most, within a drift around the expected pose.
 * The result is where a match may start, no measurement: the grid of poses is 0.4 m and 4 degrees
 * wide, as coarse as the tolerance of Overlap allows, and about 40 rays of the scan are looked at.
 *
 * Positions are searched within the displacement of the drift, headings within its rotation; both
 * reach the next step of the grid. Time grows with the square of the displacement.
 *
 *  @return of equal shares the one that comes first, which is the expected pose where nothing is
 * shared anywhere */
SharedPlace findSharedPlace(const PosedScan& reference, const PosedScan& current,
                            const Pose2& expected_T_ref_cur, const Drift& drift);
}  // namespace psmks
