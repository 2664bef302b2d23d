/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/joint/JointMatch.h>
#include <psmks/joint/JointSolver.h>
#include <psmks/joint/LinePairing.h>

namespace psmks
{
/** Refines starts by associating lines and single rays and solving for the pose, in turn. */
class Refinement
{
 public:
  explicit Refinement(JointMatch& match) : match_(match) {}

  /** Refines a start and scores what comes of it; without enough associations the score is -1.
   *  @param firstShare of the gates, for the first association */
  RefinedPose refine(const Pose2& start, double firstShare = 1);

 private:
  RefinedPose alternate(const Pose2& start, double firstShare);
  Pose2 associate(double share, bool last, RefinedPose& pose);
  double distanceGate_m(double share) const;
  bool solve(const SolverLimits& limits, Pose2& T_ref_cur);
  void score(RefinedPose& pose) const;
  void compareWithBestLinePair(RefinedPose& pose) const;

  bool hasTooFew(const RefinedPose& pose) const;
  bool isWithin(const Pose2& motion, double share) const;
  SolverLimits finalLimits() const;
  SolverLimits limitsWithin(const PairingGates& gates) const;

  JointMatch& match_;
};
}  // namespace psmks
