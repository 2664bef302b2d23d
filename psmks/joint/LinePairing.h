/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/features/ScanFeatures.h>
#include <psmks/match/JointProblem.h>

namespace psmks
{
/** Gates of an association. */
struct PairingGates
{
  double distance_m;
  double angle_rad;
  double singleRayWeight;
  double unsegmentedRaySlack_m = 0;  //!< standard deviation added to the distances of single rays
  bool fine = false;  //!< whether short lines and circles are paired, their rays then being none
};

/** Associates lines, circles and single rays of two scans at a pose and appends them to a problem.
 *
 * Lines (paper, section 2.1): a current segment goes with every reference segment that it covers
 * when seen from the reference viewpoint, where both stand within the gates over the rays they
 * share and are seen from the same side. So do short
 * lines and circles where the gates ask for them; segments that are part of an arc then do not.
 * Single rays, in both directions: with the segment or
 * patch of the other scan at their bearing, of two at a boundary the nearer.
 *
 * Differs from the paper: whole lines are compared with the covariances of both, instead of the
 * rays of one with the line of the other; the common error of a reference line is then counted
 * once.
 *
 * @return associated rays */
int pairLines(const ScanFeatures& reference, const ScanFeatures& current, const Pose2& T_ref_cur,
              const PairingGates& gates, JointProblem& problem);
}  // namespace psmks
