/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/paper/PaperOptions.h>
#include <psmks/paper/Projection.h>
#include <psmks/segmentation/SegmentedScan.h>

#include <cstdint>
#include <vector>

namespace psmks
{
/** A projected current ray held against the reference line at its bearing. */
struct Association
{
  std::size_t ray;         //!< in the DenoisedRays and the Projection
  int currentSegment;      //!< of the current scan
  int referenceSegment;    //!< of the reference scan
  double residual_m;       //!< reference value minus projected range, along the bearing
  double incidenceCosine;  //!< of the bearing to the reference line's normal, above 0
};

/** What was associated at one pose. */
struct Associations
{
  std::vector<Association> pairs;
  int refused = 0;  //!< visible rays that meet reference segments, none similar to their own

  std::vector<std::uint8_t> similar;     //!< current segment x reference segment, row by row
  std::vector<Eigen::Vector2d> normals;  //!< of the reference segments
};

/** Associates projected rays with reference segments (paper, section 2.1).
 *
 * A ray may be associated only between similar segments: r0 and phi0 differ by less than the gates
 * of the options, and the segment shows the same side. The reference value is that of the line
 * equation at the projected bearing, r0 / cos(b - phi0); no discretisation. Between the last ray of
 * a segment and the first of the next both lines are extrapolated, and the value with the smaller
 * error is kept; a line reaches less than one ray beyond its end.
 *
 * @param gateOrientation_rad heading of the current scan at which the angle gate is tested
 * @param[out] result overwritten; allocates nothing once it has served scans of these sizes */
void associate(const DenoisedRays& rays, const Projection& projection, const SegmentedScan& current,
               const SegmentedScan& reference, double gateOrientation_rad,
               const PaperOptions& options, Associations& result);
}  // namespace psmks
