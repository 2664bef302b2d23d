/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/joint/JointMatch.h>

namespace psmks
{
/** Decides what a refined pose is good for: to end the search, to be accepted, to be searched
 * beside. */
class PoseVerifier
{
 public:
  explicit PoseVerifier(const JointMatch& match) : match_(match) {}

  /** Whether a pose ends the search: it has converged, its score reaches
   *  JointOptions::confidentScore, or agreedScore where it agrees with the guess, lines hold it
   *  (isHeldByLines()), and its position is fixed or the guess is used as a measurement. */
  bool isConvincing(const RefinedPose& pose) const;

  /** Whether the true pose may be far from this one: the pose is not acceptable, or fewer than 87 %
   * of the rays are explained and at most 35 % associated. */
  bool isDoubtful(const RefinedPose& pose) const;

  /** Whether a pose may replace a guess with a covariance: at least 87 % of the rays are explained,
   * more than 35 % associated, and lines hold the pose. */
  bool isBeyondDoubt(const RefinedPose& pose) const;

  /** Whether the true pose may lie far along a wall: fewer than 87 % of the rays are explained, or
   * the scans do not fix the position. */
  bool mayBeFarOff(const RefinedPose& pose) const;

  /** Whether a match with this pose is accepted: its score reaches JointOptions::acceptScore, or
   *  0.1 more where it contradicts the guess. */
  bool isAcceptable(const RefinedPose& pose) const;

  /** What refined poses are compared by: the score, less 0.02 where the position is not fixed.
   * Along a wall poses explain the scans alike wherever they are, so that one that a door jamb
   * holds is preferred to one that nothing holds. */
  double rankingScore(const RefinedPose& pose) const;

  /** Whether at least half of the rays that lie on surfaces of the other scan are associated. A
   * pose half a degree off has most rays within the tolerance of surfaces, but few lines that pair.
   */
  bool isHeldByLines(const RefinedPose& pose) const;

  /** Whether the position along some direction is fixed by few rays, as of a door jamb or of legs:
   * its standard deviation there is above half that of a range. */
  bool isWeaklyHeld(const RefinedPose& pose) const;

  /** Whether no pair of lines knows its angle to 0.25 degrees. A curve is segmented into short
   * lines, which in a round room pair up at any heading, with small residuals each time. */
  bool hasFewStraightLines(const RefinedPose& pose) const;

  /** Whether the guess is used as a measurement and what the scans alone say of the pose agrees
   * with it (Innovation::isAgreement): two independent witnesses for one pose. */
  bool agreesWithGuess(const RefinedPose& pose) const;

  /** Whether the guess is used as a measurement and what the scans alone say of the pose
   * contradicts it (Innovation::isContradiction). */
  bool contradictsGuess(const RefinedPose& pose) const;

 private:
  bool pairsFewRays(const RefinedPose& pose) const;
  bool explainsMost(const RefinedPose& pose) const;
  bool isPositionFixed(const RefinedPose& pose) const;

  const JointMatch& match_;
};
}  // namespace psmks
