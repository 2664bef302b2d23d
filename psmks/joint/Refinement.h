/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/joint/GaussNewton.h>
#include <psmks/joint/JointMatch.h>
#include <psmks/joint/LinePairing.h>

namespace psmks
{
/** Refines starts by associating lines and single rays and solving for the pose, in turn. */
class Refinement
{
 public:
  explicit Refinement(JointMatch& match) : match_(match) {}

  /** Refines a start and scores the pose that it leads to; the score is -1 where fewer rays than
   *  JointOptions::minAssociations were associated.
   *
   *  Each round associates lines and single rays within gates, and Gauss-Newton solves for the pose
   *  with the associations held fixed. Of n = JointOptions::reassociations rounds
   *
   *  - the first n - 1 use the gates of the options, 1/2 and 1/4 of them, ..., and end early once
   *    the pose has settled;
   *  - the last uses a quarter of the gates whatever came before (all of them where n is 1), pairs
   *    short lines and circles too, and depth edges within the gate of the options, and is repeated
   *    until the pose has settled, at most six times.
   *
   *  The gate of distances is never narrower than the range noise demands. The prior is the guess
   *  where it is used as a measurement, else the start of the round with 0.3 m and 20 degrees,
   *  which acts only along what the scans do not fix.
   *  @param firstShare share of the gates of the options in the first round, and halved from it */
  RefinedPose refine(const Pose2& start, double firstShare = 1);

 private:
  RefinedPose alternate(const Pose2& start, double firstShare);
  Pose2 associate(double share, bool last, RefinedPose& pose);
  double distanceGate_m(double share) const;
  bool solve(const SolverLimits& limits, Pose2& T_ref_cur);
  void score(RefinedPose& pose) const;
  double bestAngleVariance_rad2() const;

  bool hasTooFew(const RefinedPose& pose) const;
  bool isWithin(const Pose2& motion, double share) const;
  SolverLimits finalLimits() const;
  SolverLimits limitsWithin(const PairingGates& gates) const;

  JointMatch& match_;
};
}  // namespace psmks
