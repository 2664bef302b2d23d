/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/joint/PoseVerifier.h>

namespace psmks
{
bool PoseVerifier::isConvincing(const RefinedPose& pose) const
{
  if (!pose.converged || !isHeldByLines(pose)) return false;
  const JointOptions& options = match_.options;
  if (agreesWithGuess(pose)) return pose.score >= options.agreedScore;
  if (match_.prior() || !isWeaklyHeld(pose)) return pose.score >= options.confidentScore;
  return isOpenAndUncontradicted(pose);
}

/** Whether the position is taken from the guess along some direction, and nothing is left that
 * would fix it. */
bool PoseVerifier::isOpenAndUncontradicted(const RefinedPose& pose) const
{
  /** Score from which on hardly anything is left that another pose could explain. Unit: score.
   * Evidence: of 400 pairs in bare corridors none scores less than 0.996. */
  constexpr double kNothingLeft = 0.95;
  return pose.observability.weakSigma_m > match_.unobservableSigma_m() &&
         pose.score >= kNothingLeft;
}

bool PoseVerifier::isDoubtful(const RefinedPose& pose) const
{
  /** Score at which as much speaks against a pose as for it. Unit: score. Definition:
   * freeSpaceScore(). */
  constexpr double kEven = 0.5;
  return pose.score < kEven || !isAcceptable(pose) || (!explainsMost(pose) && pairsFewRays(pose));
}

bool PoseVerifier::isBeyondDoubt(const RefinedPose& pose) const
{
  return explainsMost(pose) && isHeldByLines(pose) && !pairsFewRays(pose);
}

bool PoseVerifier::pairsFewRays(const RefinedPose& pose) const
{
  /** A pose that pairs a smaller share of the rays pairs few. Unit: share of the rays.
   * Evidence: measured. */
  constexpr double kFew = 0.35;
  return !match_.pairsMoreThan(kFew, pose);
}

bool PoseVerifier::explainsMost(const RefinedPose& pose) const
{
  /** Score from which on a pose explains most of the rays. Unit: score. Evidence: of poses that
   * were the best of their pair, 99.9 % of those with a score from 0.7 on are right, 98.2 % of
   * those from 0.6 to 0.7 (docs/benchmarks.md, "Likelihood of the rays"). */
  constexpr double kMostRays = 0.7;
  return pose.score >= kMostRays;
}

bool PoseVerifier::isAcceptable(const RefinedPose& pose) const
{
  /** What a pose has to explain more in order to contradict a measured guess. Unit: score.
   * Evidence: measured. */
  constexpr double kMoreToContradict = 0.15;

  /** Share of JointOptions::acceptScore that is enough where a measured guess agrees. Unit: none.
   * Evidence: measured; and csail's steps from odometry over 2, 4 and 8 scans: 98.7, 98.0 and 88.6
   * % right with it, 98.1, 96.1 and 79.0 % without, as many wrong. */
  constexpr double kAgreedShare = 0.5;
  const double accepted = match_.options.acceptScore;
  if (contradictsGuess(pose)) return pose.score >= accepted + kMoreToContradict;
  return pose.score >= (agreesWithGuess(pose) ? kAgreedShare : 1) * accepted;
}

bool PoseVerifier::isHeldByLines(const RefinedPose& pose) const
{
  /** Share of the rays on surfaces that the pairs have to hold. Unit: share of the rays. Evidence:
   * measured. */
  constexpr double kFewestHeld = 0.5;
  return pose.associations >= kFewestHeld * pose.inlierRays;
}

bool PoseVerifier::isWeaklyHeld(const RefinedPose& pose) const
{
  /** Standard deviation of the position from which on a few rays hold a pose, as a share of that of
   * a range. Unit: standard deviations of a range. Evidence: two rays on a wall ahead, one of each
   * scan, know the distance to sqrt(2) of it, eight such pairs to half of it. */
  constexpr double kFewRays = 0.5;
  return pose.observability.weakSigma_m > kFewRays * match_.rangeSigma_m;
}

bool PoseVerifier::hasFewStraightLines(const RefinedPose& pose) const
{
  /** Standard deviation of an angle below which a pair of lines knows the heading well. Evidence:
   * measured. */
  constexpr double kWellKnown_rad = degToRad(0.25);
  return pose.angleVariance_rad2 >= kWellKnown_rad * kWellKnown_rad;
}

bool PoseVerifier::agreesWithGuess(const RefinedPose& pose) const
{
  return match_.prior() && pose.innovation.isAgreement();
}

bool PoseVerifier::contradictsGuess(const RefinedPose& pose) const
{
  return match_.prior() && pose.innovation.isContradiction();
}
}  // namespace psmks
