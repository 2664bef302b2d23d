/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/features/ScanFeatures.h>
#include <psmks/match/JointProblem.h>

namespace psmks
{
/** Limits within which lines and rays of two scans are associated, and the weight of single rays.
 */
struct PairingGates
{
  double distance_m;                 //!< greatest distance between associated lines
  double angle_rad;                  //!< greatest angle between associated lines
  double singleRayWeight;            //!< of unsegmented rays, 0 to 1
  double unsegmentedRaySlack_m = 0;  //!< standard deviation added to the distances of single rays

  double edgeDistance_m = 0;  //!< greatest distance between depth edges; 0: none are paired

  /** Whether short lines and circles are paired too. The rays of every short line, paired or not,
   *  and of every paired circle are then no single rays. */
  bool pairShortLinesAndCircles = false;
};

/** Associates lines, circles and single rays of two scans at a pose and appends them to a problem.
 *
 *  Lines (paper, section 2.1): a current segment goes with every reference segment that it covers
 *  when seen from the reference viewpoint, where both stand within the gates over the rays they
 *  share and are seen from the same side.
 *
 *  Where PairingGates::pairShortLinesAndCircles is set, short lines are paired in the same way, and
 *  segments that are part of an arc are not. Circles are paired by pairCircles(): each is the
 *  nearest one to the other, and their radii agree.
 *
 *  Depth edges are paired by pairEdges(), within PairingGates::edgeDistance_m.
 *
 *  Single rays of either scan go with the segment or surfel of the other scan at their bearing, and
 *  of two at a boundary with the nearer one.
 *
 *  Differs from the paper: whole lines are compared with the covariances of both, instead of the
 *  rays of one with the line of the other; the common error of a reference line is then counted
 *  once.
 *
 *  @return associated rays */
int associateFeatures(const ScanFeatures& reference, const ScanFeatures& current,
                      const Pose2& T_ref_cur, const PairingGates& gates, JointProblem& problem);
}  // namespace psmks
