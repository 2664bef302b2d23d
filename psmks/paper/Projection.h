/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/segmentation/SegmentedScan.h>

#include <cstdint>
#include <vector>

namespace psmks
{
/** The valid rays of a scan as points in its own frame. A ray that belongs to a segment ends on the
 * line of the segment (de-noised), any other where it was measured. All vectors have an entry for
 * each valid ray. */
struct DenoisedRays
{
  std::vector<int> ray;
  std::vector<int> segment;  //!< index of the segment, or SegmentedScan::kNoSegment
  std::vector<double> x_m, y_m;

  /** 1 if the point and the one before it lie on one surface, which then hides what is behind it:
   * they belong to the same segment, or are neighbours outside segments with nearly the same range.
   * On a closed scan the point before the first one is the last one. */
  std::vector<std::uint8_t> continuesSurface;
  std::vector<int> surface;  //!< number of its surface; equal for all points on one surface

  std::size_t size() const { return ray.size(); }
  void assign(const SegmentedScan& scan);

 private:
  void joinSurfaces(const SegmentedScan& scan);
};

/** How the reference viewpoint sees the end point of a current ray. */
enum class RayMark : std::uint8_t
{
  Visible,
  SeenFromBehind,  //!< successive bearings of its surface do not increase
  Hidden,          //!< a nearer surface covers its bearing
  OutsideView,     //!< its bearing is outside the field of view
  BeyondRange      //!< at or beyond the maximum range of the reference scan
};

/** The current scan as seen from the reference viewpoint if the current one is at a given pose. The
 * vectors of rays have an entry for each of the DenoisedRays. */
struct Projection
{
  std::vector<double> x_m, y_m;  //!< in the reference frame
  std::vector<double> range_m;
  std::vector<double> index;  //!< fractional ray index of the bearing on the reference grid
  std::vector<RayMark> mark;

  std::vector<Line> lines;               //!< of the current segments, in the reference frame
  std::vector<std::uint8_t> lineTurned;  //!< 1 if the segment is seen from its other side

  /** The nearest of the projected surfaces along a reference ray. */
  struct Nearest
  {
    double nearness_1pm = 0;  //!< 1 / range, in 1/m (1pm: one per metre); 0 if there is no surface
    int surface = -1;
  };
  std::vector<Nearest> nearest;  //!< one per reference ray
};

/** Projects the current scan to the reference viewpoint (paper, section 2.1; original PSM, step 2)
 *  and marks what cannot be seen from there.
 *
 * Two rules find what is occluded. First, a surface is seen from behind if the bearings along it
 * decrease (Fig. 1a); the line of a segment shows this without a previous point (Fig. 1b). Second,
 * a point is hidden if a nearer surface lies at its bearing. All surfaces, whichever side they
 * show, are drawn on a buffer that holds the nearest surface along each reference ray.
 *
 * Differs from the paper: it drops each ray whose bearing is smaller than that of any previous ray.
 * If the bearing falls back from a far object to a nearer one, this drops the nearer object, though
 * it is the far one that is hidden.
 *
 * @param rays of the current scan
 * @param[out] result overwritten; nothing is allocated if earlier scans had these sizes */
void projectScan(const DenoisedRays& rays, const SegmentedScan& current, const Pose2& T_ref_cur,
                 const SegmentedScan& reference, Projection& result);
}  // namespace psmks
