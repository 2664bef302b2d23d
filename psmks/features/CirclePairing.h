/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/features/Circles.h>
#include <psmks/match/JointProblem.h>

#include <bitset>
#include <vector>

namespace psmks
{
/** Which circles of two scans are paired. */
struct PairedCircles
{
  std::bitset<kMostCircles> reference, current;  //!< one bit per circle
  int rays = 0;                                  //!< rays of the current scan on its paired circles
};

/** Pairs the circles of two scans at a pose. Two circles are a pair if each is the nearest one to
 * the other, their radii agree, and their centres are within the gate once both are taken for one
 * circle of one radius, equation (4) of docs/derivations.md.
 *
 * Differs from the paper: it pairs segments alone.
 *
 *  @param gate_m largest distance of the centres
 *  @param[in,out] pairs the pairs are appended to it */
PairedCircles pairCircles(const std::vector<Circle>& reference, const std::vector<Circle>& current,
                          const Pose2& T_ref_cur, double gate_m,
                          std::vector<CirclePairTerm>& pairs);
}  // namespace psmks
