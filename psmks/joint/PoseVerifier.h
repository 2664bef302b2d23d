/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/joint/JointMatch.h>

namespace psmks
{
/** Tells how far a refined pose may be trusted. */
class PoseVerifier
{
 public:
  explicit PoseVerifier(const JointMatch& match) : match_(match) {}

  /** Whether a pose leaves no doubt: it has settled, its score is high, and lines hold it in place
   * where rays lie on surfaces. A pose half a degree off can still have its rays within the
   * tolerance of most surfaces, but the lines there are then no pairs. */
  bool isConvincing(const RefinedPose& pose) const;

  /** Whether so few rays are explained, or explained by few pairs of lines, that the true pose may
   * be quite another one. */
  bool isDoubtful(const RefinedPose& pose) const;

  /** Whether a pose may stand against a measured guess: most rays are explained, many of them by
   * pairs of lines. */
  bool isBeyondDoubt(const RefinedPose& pose) const;

  /** Whether the true pose may lie far along a wall: much stays unexplained, or the lines leave
   * open where it is. */
  bool mayBeFarOff(const RefinedPose& pose) const;

  /** Whether so many rays are explained that a match with this pose is accepted: more where it
   * contradicts a measured guess. */
  bool isAcceptable(const RefinedPose& pose) const;

  /** What poses are compared by. Along a wall poses explain the scans alike wherever they are, but
   * for a door jamb: one that has found it is worth more than one that slides. */
  double rankingScore(const RefinedPose& pose) const;

  /** Whether of the rays that lie on surfaces enough are associated. */
  bool isHeldByLines(const RefinedPose& pose) const;

  /** Whether a direction is held by a few rays, of a door jamb or of somebody's legs. */
  bool isWeaklyHeld(const RefinedPose& pose) const;

  /** Whether no pair of lines is straight for long enough to know its direction well. A curve is
   * cut into short pieces of line, whose directions are no more than those of the pieces: in a
   * round room they pair up at any heading, each time with confidence. */
  bool hasFewStraightLines(const RefinedPose& pose) const;

  /** Whether the guess was measured and the pose lies within its 95 % ellipsoid: two witnesses for
   * one pose. */
  bool agreesWithGuess(const Pose2& T_ref_cur) const;

  /** Whether the guess was measured and the pose lies outside its 99.9 % ellipsoid. */
  bool contradictsGuess(const Pose2& T_ref_cur) const;

 private:
  bool pairsFewRays(const RefinedPose& pose) const;
  bool explainsMost(const RefinedPose& pose) const;
  bool isPositionFixed(const RefinedPose& pose) const;
  double chi2FromGuess(const Pose2& T_ref_cur) const;

  const JointMatch& match_;
};
}  // namespace psmks
