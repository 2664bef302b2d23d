/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/features/Circles.h>
#include <psmks/match/JointProblem.h>

#include <bitset>
#include <vector>

namespace psmks
{
/** Which circles of two scans have found each other. */
struct PairedCircles
{
  std::bitset<kMostCircles> reference, current;
  int rays = 0;  //!< of the current scan, on paired circles
};

/** Associates circles at a pose: two that are nearest to each other, whose radii agree, and that
 * stand within the gate once they are taken for one circle of one radius.
 *
 * @param[in,out] pairs the pairs are appended */
PairedCircles pairCircles(const std::vector<Circle>& reference, const std::vector<Circle>& current,
                          const Pose2& T_ref_cur, double gate_m,
                          std::vector<CirclePairTerm>& pairs);
}  // namespace psmks
