/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/segmentation/SegmentedScan.h>

#include <vector>

namespace psmks
{
/** A round thing seen from outside: a pillar, a pole, the trunk of a tree, a leg. */
struct Circle
{
  Eigen::Vector2d centre_m;
  double radius_m;
  Eigen::Matrix3d covariance;  //!< of (centre x, centre y, radius), m^2
  int firstRay, lastRay;       //!< index on the grid
};

/** Most circles of one scan; no more are looked for. Unit: circles. Definition: capacity of bit
 * sets. */
constexpr std::size_t kMostCircles = 64;

/** Finds the round things among the rays that belong to no segment.
 *
 *       .--.
 *      (    )       4 rays or more in a row that see its near side, bent enough to tell from a
 *       o  o        straight line, to the noise on a circle
 *        oo
 *         |
 *      scanner
 *
 * From few rays centre and radius are poorly known, but their errors go together: what faces the
 * scanner is known well. The covariance says so.
 *
 * Differs from the paper: there such rays are single points, which are not matched.
 *
 * @param[out] circles in the order of their rays
 * @param[out] circleOfRay index into circles of every ray, or -1 */
void findCircles(const SegmentedScan& scan, std::vector<Circle>& circles,
                 std::vector<int>& circleOfRay);
}  // namespace psmks
