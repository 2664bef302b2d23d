/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Pose2.h>
#include <psmks/geometry/Scan.h>

#include <vector>

namespace psmks
{
/** How much of a scan another scan has seen, at poses that are known to some decimetres.
 *
 * A return of the current scan counts as seen where the reference has a return in about the same
 * direction, on a neighbouring ray, at about the same range. The tolerance of the range is 30 cm
 * and 5 % of the range, since the pose may be wrong by that much and a wrong heading moves far
 * returns more. */
class Overlap
{
 public:
  /** @param reference kept by reference
   *  @param stride of the current scan each ray of which the index is a multiple is looked at */
  Overlap(const Scan& reference, const Scan& current, int stride);

  /** The share of the returns of the current scan that the reference has seen, 0 to 1. It is small
   * where the scans look past each other, or at the two sides of a wall. 0 where a scan has no
   * returns, or not as many ranges as its grid has rays.
   *  @param T_ref_cur of the two sensors */
  double at(const Pose2& T_ref_cur) const;

 private:
  bool isSeen(const Eigen::Vector2d& point_m) const;

  const Scan& reference_;
  std::vector<Eigen::Vector2d> returns_m_;  //!< of the current scan, in its own frame
};

/** The overlap at one pose, from every fourth ray of the current scan, which is enough for a share.
 */
double overlap(const Scan& reference, const Scan& current, const Pose2& T_ref_cur);
}  // namespace psmks
