/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Pose2.h>
#include <psmks/psm/PsmScan.h>

namespace psmks
{
/** The ranges that the reference viewpoint would measure to the surfaces of the current scan, along
 * the reference rays. */
struct PsmProjection
{
  std::vector<double> range_m;  //!< one per reference ray; infinite if the tag is Empty
  std::vector<PsmTag> tag;      //!< one per reference ray: Good, Occluded or Empty
};

/** Computes the current scan as the reference viewpoint would see it (Diosi and Kleeman 2007). Two
 * neighbouring points of one surface cover the reference rays between them, with ranges
 * interpolated along the bearing, and the nearest surface counts. A surface along which the
 * bearings decrease is seen from behind: it is Occluded, but hides what is farther away.
 *
 * Parts of the reference scan that the current viewpoint cannot see are not marked.
 *
 *  @param T_ref_cur finite */
void projectPsmScan(const PsmScan& current, const Pose2& T_ref_cur, const BeamGrid& referenceGrid,
                    PsmProjection& result);
}  // namespace psmks
