/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/paper/PaperOptions.h>
#include <psmks/paper/Projection.h>
#include <psmks/segmentation/SegmentedScan.h>

#include <cstdint>
#include <vector>

namespace psmks
{
/** A projected ray of the current scan, compared with the reference line at its bearing. */
struct Association
{
  std::size_t ray;         //!< index in the DenoisedRays and the Projection
  int currentSegment;      //!< index of its segment in the current scan
  int referenceSegment;    //!< index of the associated segment in the reference scan
  double residual_m;       //!< reference value minus projected range, along the bearing
  double incidenceCosine;  //!< cosine of the angle between bearing and reference line's normal, > 0
};

/** All associations at one pose. */
struct Associations
{
  std::vector<Association> pairs;
  int refused = 0;  //!< rays that meet a reference segment, but none similar to their own

  /** 1 if two segments are similar; a row for each current segment. */
  std::vector<std::uint8_t> similar;
  std::vector<Eigen::Vector2d> normals;  //!< of the reference segments, in their order
};

/** Associates projected rays with reference segments (paper, section 2.1).
 *
 * A ray is associated only with a segment that is similar to its own: r0 and phi0 of the two differ
 * by less than the gates of the options, and both show the same side. The reference value is the
 * range on the reference line at the projected bearing, r0 / cos(b - phi0), without discretisation.
 * Between the last ray of a segment and the first ray of the next one, both lines are extrapolated
 * by less than one ray, and the association with the smaller residual is kept.
 *
 * @param gateOrientation_rad heading of the current scan at which the angle gate is tested
 * @param[out] result overwritten; nothing is allocated if earlier scans had these sizes */
void associate(const DenoisedRays& rays, const Projection& projection, const SegmentedScan& current,
               const SegmentedScan& reference, double gateOrientation_rad,
               const PaperOptions& options, Associations& result);
}  // namespace psmks
