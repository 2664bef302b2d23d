/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Pose2.h>
#include <psmks/psm/PsmScan.h>

namespace psmks
{
/** What the reference viewpoint would measure of the current scan's surfaces, on its own rays. */
struct PsmProjection
{
  std::vector<double> range_m;  //!< one per reference ray; infinite where Empty
  std::vector<PsmTag> tag;      //!< one per reference ray: Good, Occluded or Empty
};

/** Draws the current scan as the reference viewpoint would see it (Diosi and Kleeman 2007).
 *  Two neighbouring points of one surface cover the reference rays between them, with ranges
 *  interpolated along the bearing; the nearest surface stays. One whose bearings run backwards is
 *  seen from behind: it is Occluded, but hides what is farther.
 *
 *  What the current viewpoint cannot see of the reference scan is not looked for.
 *
 *  @param T_ref_cur finite */
void projectPsmScan(const PsmScan& current, const Pose2& T_ref_cur, const BeamGrid& referenceGrid,
                    PsmProjection& result);
}  // namespace psmks
