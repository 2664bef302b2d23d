/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/base/Stopwatch.h>
#include <psmks/joint/JointConclusion.h>

#include <Eigen/LU>
#include <cmath>

namespace psmks
{
void JointConclusion::conclude(int mostAssociations)
{
  const JointOptions& options = match_.options;
  if (mostAssociations < options.minAssociations)
  {
    result_.status = MatchStatus::TooFewAssociations;
    return;
  }
  result_.score = best_.score;
  result_.associations = best_.associations;
  if (!verifier_.isAcceptable(best_))
  {
    result_.status = MatchStatus::NoImprovement;
    return;
  }
  accept();
}

void JointConclusion::accept()
{
  Stopwatch watch;
  result_.status = best_.converged ? MatchStatus::Converged : MatchStatus::MaxIterations;
  result_.T_ref_cur = best_.T_ref_cur;
  result_.errorAfter = 1 - best_.score;
  settleUnobservable();
  const Eigen::Matrix3d prior = match_.guessPrior
                                    ? match_.guessPrior->information
                                    : MatchResult::unknownCovariance().inverse().eval();
  result_.covariance = (best_.information + prior).inverse();
  addAmbiguity();
  if (verifier_.hasFewStraightLines(best_) && isHeadingOpen()) markHeadingUnobservable(prior(2, 2));
  result_.times.scoring_s += watch.lap_s();
}

/** What the scans do not fix is flagged, and where it is wide open put back to the guess. */
void JointConclusion::settleUnobservable()
{
  const Observability& o = best_.observability;
  if (o.weakSigma_m > match_.weakDirectionSigma_m())
    settleDirection(o.weakDirection, o.weakSigma_m);
  if (o.headingSigma_rad > match_.options.weakHeadingSigma_rad)
  {
    result_.status = MatchStatus::Degenerate;
    result_.headingUnobservable = true;
    result_.T_ref_cur.phi_rad = match_.guess.T_ref_cur.phi_rad;
  }
}

void JointConclusion::settleDirection(const Eigen::Vector2d& weakDirection, double weakSigma_m)
{
  constexpr double kWideOpen_m = 0.05, kWideOpenWithPrior_m = 0.03;
  result_.status = MatchStatus::Degenerate;
  result_.unobservableDirection = weakDirection;
  if (weakSigma_m <= (match_.guessPrior ? kWideOpenWithPrior_m : kWideOpen_m)) return;
  const double moved_m =
      weakDirection.dot(result_.T_ref_cur.translation() - match_.guess.T_ref_cur.translation());
  result_.T_ref_cur.x_m -= moved_m * weakDirection.x();
  result_.T_ref_cur.y_m -= moved_m * weakDirection.y();
}

/** Where another pose along the same walls explains as much, the position between both is open. */
void JointConclusion::addAmbiguity()
{
  for (const RefinedPose& other : match_.buffers.refinedPoses)
  {
    if (!isAmbiguousWith(other)) continue;
    const Eigen::Vector2d between_m = other.T_ref_cur.translation() - best_.T_ref_cur.translation();
    result_.status = MatchStatus::Degenerate;
    result_.unobservableDirection = between_m.normalized();
    result_.covariance.topLeftCorner<2, 2>() += between_m * between_m.transpose();
  }
}

bool JointConclusion::isAmbiguousWith(const RefinedPose& other) const
{
  constexpr double kSameHeading_rad = degToRad(2), kElsewhere_m = 0.1;
  constexpr double kNearTie = 0.05, kNearTieUnheld = 0.2;
  const Pose2 apart = best_.T_ref_cur.inverse() * other.T_ref_cur;
  const bool isElsewhere =
      apart.translation().norm() > kElsewhere_m && std::abs(apart.phi_rad) < kSameHeading_rad;
  const double tie = verifier_.isHeldByLines(best_) ? kNearTie : kNearTieUnheld;
  return isElsewhere && other.score >= best_.score - tie &&
         !verifier_.contradictsGuess(other.T_ref_cur);
}

/** Puts the heading to the test: whether a start turned away, to either side, stays away and
 * explains the scans as well. Where a measured guess confirms the pose, one side is asked. */
bool JointConclusion::isHeadingOpen()
{
  constexpr double kTurn_rad = degToRad(5);
  return convergesElsewhere(kTurn_rad) ||
         (!verifier_.agreesWithGuess(best_.T_ref_cur) && convergesElsewhere(-kTurn_rad));
}

bool JointConclusion::convergesElsewhere(double turn_rad)
{
  Pose2 turned = best_.T_ref_cur;
  turned.phi_rad = wrapAngle(turned.phi_rad + turn_rad);
  const RefinedPose other = refinement_.refine(turned);
  const double apart_rad = wrapAngle(other.T_ref_cur.phi_rad - best_.T_ref_cur.phi_rad);
  return explainsAsMuch(other) && std::abs(apart_rad) > match_.options.weakHeadingSigma_rad;
}

bool JointConclusion::explainsAsMuch(const RefinedPose& other) const
{
  constexpr double kSameScore = 0.03;
  return other.score > best_.score - kSameScore;
}

/** The guess's heading, the position that goes with it, and its uncertainty. Where the scans are
 * not explained as well at that heading - it is open about the pose, but not as far as the guess -
 * the pose stays.
 *  @param priorInformation of the heading, 1/rad^2 */
void JointConclusion::markHeadingUnobservable(double priorInformation)
{
  result_.status = MatchStatus::Degenerate;
  result_.headingUnobservable = true;
  result_.covariance(2, 2) += 1 / priorInformation;
  Pose2 atGuess = best_.T_ref_cur;
  atGuess.phi_rad = match_.guess.T_ref_cur.phi_rad;
  const RefinedPose other = refinement_.refine(atGuess);
  if (!explainsAsMuch(other)) return;
  result_.T_ref_cur = other.T_ref_cur;
  result_.T_ref_cur.phi_rad = match_.guess.T_ref_cur.phi_rad;
}
}  // namespace psmks
