/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/segmentation/SegmentedScan.h>

#include <vector>

namespace psmks
{
/** A round object seen from outside: a pillar, a pole, the trunk of a tree, a leg. */
struct Circle
{
  Eigen::Vector2d centre_m;    //!< in the sensor frame
  double radius_m;             //!< above 0
  Eigen::Matrix3d covariance;  //!< of (centre x, centre y, radius), m^2
  int firstRay, lastRay;       //!< indices on the grid
};

/** Most circles of one scan; no more are looked for. Unit: circles. Definition: capacity of bit
 * sets. */
constexpr std::size_t kMostCircles = 64;

// clang-format off
/** Finds circles among the rays that are on no segment, or on short ones.
 *
 *       .--.
 *      (    )       A circle is seen by 4 consecutive rays or more, which bend
 *       o  o        significantly and lie on it within the noise of their ranges.
 *        oo
 *         |
 *      scanner
 *
 * A short arc leaves the centre and the radius uncertain, but their errors are correlated: the side
 * that faces the scanner is known well. The covariance tells so (docs/derivations.md, "Circles").
 *
 * Differs from the paper: there such rays are single points, which are not matched.
 *
 *  @param[out] circles in the order of their rays, kMostCircles at most; what it held is replaced
 *  @param[out] circleOfRay index into `circles` for every ray, or -1 */
void findCircles(const SegmentedScan& scan, std::vector<Circle>& circles,
                 std::vector<int>& circleOfRay);
// clang-format on
}  // namespace psmks
