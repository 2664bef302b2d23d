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

  /** Whether a pose ends the search: it has converged, lines hold it (isHeldByLines()), and its
   *  score reaches JointOptions::confidentScore, or agreedScore where it agrees with a measured
   *  guess. Where few rays hold the position (isWeaklyHeld()) and the guess is no measurement,
   *  another place along that direction may explain the scans as well, and no score convinces; but
   *  where the position is not observable along it, and so that of the guess, and the score is at
   *  least 0.95. */
  bool isConvincing(const RefinedPose& pose) const;

  /** Whether the true pose may be far from this one: more speaks against the pose than for it
   * (score below 0.5), or it is not acceptable, or its score is below 0.7 and at most 35 % of the
   * rays are associated. */
  bool isDoubtful(const RefinedPose& pose) const;

  /** Whether a pose may replace a guess with a covariance: a score of at least 0.7, more than 35 %
   * of the rays associated, and lines hold the pose. */
  bool isBeyondDoubt(const RefinedPose& pose) const;

  /** Whether a match with this pose is accepted: its score reaches JointOptions::acceptScore; half
   *  of that where it agrees with a measured guess, which is a second witness, and 0.15 more where
   *  it contradicts one. */
  bool isAcceptable(const RefinedPose& pose) const;

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
  bool isOpenAndUncontradicted(const RefinedPose& pose) const;
  bool pairsFewRays(const RefinedPose& pose) const;
  bool explainsMost(const RefinedPose& pose) const;

  const JointMatch& match_;
};
}  // namespace psmks
