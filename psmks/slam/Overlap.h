/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Pose2.h>
#include <psmks/geometry/Scan.h>

#include <vector>

namespace psmks
{
/** How much of a scan another one has seen, at poses known to some decimetres. */
class Overlap
{
 public:
  /** Keeps the reference by reference.
   *  @param stride every so many rays of the current scan are looked at */
  Overlap(const Scan& reference, const Scan& current, int stride);

  /** Share of the returns of the current scan that lie near what the reference saw at their
   * bearing, 0 to 1; 0 where the ranges of one do not fit its grid. Small where the scans look at
   * different things: past each other, or at two sides of a wall. */
  double at(const Pose2& T_ref_cur) const;

 private:
  bool isSeen(const Eigen::Vector2d& point_m) const;

  const Scan& reference_;
  std::vector<Eigen::Vector2d> returns_m_;  //!< of the current scan, in its frame
};

/** Overlap at one pose, from every fourth ray: a share needs no more. */
double overlap(const Scan& reference, const Scan& current, const Pose2& T_ref_cur);
}  // namespace psmks
