/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/segmentation/SegmentedScan.h>

#include <cstdint>
#include <vector>

namespace psmks
{
/** The valid rays of a scan as points in its own frame: on the line of their segment where they
 * have one (de-noised), as measured where they are single. All vectors run over the valid rays. */
struct DenoisedRays
{
  std::vector<int> ray;
  std::vector<int> segment;  //!< or SegmentedScan::kNoSegment
  std::vector<double> x_m, y_m;

  /** 1 where this point and the one before it lie on one surface, so that what is between them
   * hides what is behind: the same segment, or two single neighbours of nearly the same range. The
   * point before the first is the last on a closed scan. */
  std::vector<std::uint8_t> continuesSurface;
  std::vector<int> surface;  //!< the same number for points on one surface

  std::size_t size() const { return ray.size(); }
  void assign(const SegmentedScan& scan);

 private:
  void joinSurfaces(const SegmentedScan& scan);
};

/** What the reference viewpoint sees of a current ray's end point. */
enum class RayMark : std::uint8_t
{
  Visible,
  SeenFromBehind,  //!< its surface turns its back: successive bearings do not advance
  Hidden,          //!< a nearer surface covers its bearing
  OutsideView,     //!< its bearing is outside the field of view
  BeyondRange      //!< at or beyond the reference's maximum range
};

/** The current scan as the reference viewpoint would see it from a supposed pose. The per-ray
 * vectors run over the DenoisedRays. */
struct Projection
{
  std::vector<double> x_m, y_m;  //!< reference frame
  std::vector<double> range_m;
  std::vector<double> index;  //!< fractional ray index of the bearing on the reference grid
  std::vector<RayMark> mark;

  std::vector<Line> lines;               //!< of the current segments, reference frame
  std::vector<std::uint8_t> lineTurned;  //!< 1 where a segment is seen from its other side

  /** The nearest of the projected surfaces at a reference ray. */
  struct Nearest
  {
    double nearness_1pm = 0;  //!< 1 / range, 0 where there is none
    int surface = -1;
  };
  std::vector<Nearest> nearest;  //!< one per reference ray
};

/** Projects the current scan to the reference viewpoint (paper, section 2.1; original PSM, step 2)
 *  and marks what cannot be seen from there.
 *
 * Occlusions come from two rules. A surface seen from behind shows itself by bearings that run
 * backwards (Fig. 1a); of a segment that is known from its line alone, so that no previous point is
 * needed (Fig. 1b). A point behind a nearer surface is found on a buffer of the nearest surface per
 * reference ray, on which every surface is drawn, whichever side it shows.
 *
 * Differs from the paper: that drops every ray whose bearing lies behind that of any previous ray.
 * Where the bearing falls back from a far object to a nearer one, it is the far one that is hidden.
 *
 * @param rays of the current scan
 * @param[out] result overwritten; allocates nothing once it has served scans of these sizes */
void projectScan(const DenoisedRays& rays, const SegmentedScan& current, const Pose2& T_ref_cur,
                 const SegmentedScan& reference, Projection& result);
}  // namespace psmks
