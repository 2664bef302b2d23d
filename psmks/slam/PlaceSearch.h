/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/slam/PosedScan.h>
#include <psmks/slam/ReferencePolicy.h>

namespace psmks
{
/** The pose, within the drift around an expected one, at which two scans share most, on a coarse
 * grid: a start for a match. */
struct SharedPlace
{
  Pose2 T_ref_cur;     //!< of the robots
  double overlap = 0;  //!< see overlap()
};

SharedPlace findSharedPlace(const PosedScan& reference, const PosedScan& current,
                            const Pose2& expected_T_ref_cur, const Drift& drift);
}  // namespace psmks
