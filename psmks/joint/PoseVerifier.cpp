/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/joint/PoseVerifier.h>

namespace psmks
{
bool PoseVerifier::isConvincing(const RefinedPose& pose) const
{
  const JointOptions& options = match_.options;
  const double enough = agreesWithGuess(pose) ? options.agreedScore : options.confidentScore;
  return pose.converged && pose.score >= enough && isHeldByLines(pose) &&
         (match_.prior() || isPositionFixed(pose));
}

bool PoseVerifier::isDoubtful(const RefinedPose& pose) const
{
  return !isAcceptable(pose) || (!explainsMost(pose) && pairsFewRays(pose));
}

bool PoseVerifier::isBeyondDoubt(const RefinedPose& pose) const
{
  return explainsMost(pose) && isHeldByLines(pose) && !pairsFewRays(pose);
}

bool PoseVerifier::pairsFewRays(const RefinedPose& pose) const
{
  constexpr double kFew = 0.35;
  return !match_.pairsMoreThan(kFew, pose);
}

bool PoseVerifier::mayBeFarOff(const RefinedPose& pose) const
{
  return !explainsMost(pose) || !isPositionFixed(pose);
}

bool PoseVerifier::explainsMost(const RefinedPose& pose) const
{
  constexpr double kMostRays = 0.87;
  return pose.score >= kMostRays;
}

bool PoseVerifier::isAcceptable(const RefinedPose& pose) const
{
  constexpr double kMoreToContradict = 0.1;  // a measured guess
  return pose.score >=
         match_.options.acceptScore + (contradictsGuess(pose) ? kMoreToContradict : 0);
}

double PoseVerifier::rankingScore(const RefinedPose& pose) const
{
  constexpr double kSliding = 0.02;
  return pose.score - (isPositionFixed(pose) ? 0 : kSliding);
}

bool PoseVerifier::isHeldByLines(const RefinedPose& pose) const
{
  constexpr double kFewestHeld = 0.5;
  return pose.associations >= kFewestHeld * pose.inlierRays;
}

bool PoseVerifier::isPositionFixed(const RefinedPose& pose) const
{
  return pose.observability.weakSigma_m <= match_.weakDirectionSigma_m();
}

bool PoseVerifier::isWeaklyHeld(const RefinedPose& pose) const
{
  // Two rays on a wall ahead, one of each scan, know the distance to sqrt(2) sigma: as well as this
  // by eight such pairs.
  constexpr double kFewRays = 0.5;
  return pose.observability.weakSigma_m > kFewRays * match_.rangeSigma_m;
}

bool PoseVerifier::hasFewStraightLines(const RefinedPose& pose) const
{
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
