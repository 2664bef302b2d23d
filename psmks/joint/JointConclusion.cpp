/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/base/Stopwatch.h>
#include <psmks/joint/DistinctOptima.h>
#include <psmks/joint/JointConclusion.h>
#include <psmks/joint/OpenDirections.h>

#include <cmath>

namespace psmks
{
namespace
{
Eigen::Vector3d difference(const Pose2& a, const Pose2& b)
{
  return {b.x_m - a.x_m, b.y_m - a.y_m, wrapAngle(b.phi_rad - a.phi_rad)};
}
}  // namespace

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
  accepted_ = best_;
  result_.T_ref_cur = accepted_.T_ref_cur;
  scans_ = accepted_.scans;
  settleHeading();
  settleDirection();
  settleCovariance();
  settleAmbiguity();
  if (match_.guess.covariance)
    result_.innovation = innovation({match_.guess.T_ref_cur, *match_.guess.covariance},
                                    accepted_.T_ref_cur, scans_.H, scans_.g);
  result_.times.scoring_s += watch.lap_s();
}

/** An unobservable heading is that of the guess. Where the scans do not admit that heading, another
 * one that they admit makes the pose ambiguous. */
void JointConclusion::settleHeading()
{
  const bool isWeak =
      accepted_.observability.headingSigma_rad > match_.options.weakHeadingSigma_rad;
  if (!isWeak && !(verifier_.hasFewStraightLines(accepted_) && isHeadingOpen())) return;
  const double guess_rad = match_.guess.T_ref_cur.phi_rad;
  const RefinedPose atGuess = refinement_.refine(
      turnedTo(guess_rad, accepted_.T_ref_cur, accepted_.scans.H, match_.unobservableSigma_m()));
  const bool isAdmitted = explainsAsMuch(atGuess);
  if (isAdmitted) accepted_ = atGuess;
  if (isAdmitted || isWeak) takeHeadingOfGuess();
}

/** Puts the heading to the test: whether a start turned away, to either side, stays away and
 * explains the scans as well. Where a measured guess confirms the pose, one side is asked. */
bool JointConclusion::isHeadingOpen()
{
  /** Turn of the starts that test whether the heading is open. Evidence: measured. */
  constexpr double kTurn_rad = degToRad(5);
  return convergesElsewhere(kTurn_rad) ||
         (!verifier_.agreesWithGuess(best_) && convergesElsewhere(-kTurn_rad));
}

bool JointConclusion::convergesElsewhere(double turn_rad)
{
  Pose2 turned = best_.T_ref_cur;
  turned.phi_rad = wrapAngle(turned.phi_rad + turn_rad);
  const RefinedPose other = refinement_.refine(turned);
  const double apart_rad = wrapAngle(other.T_ref_cur.phi_rad - best_.T_ref_cur.phi_rad);
  const bool isElsewhere =
      explainsAsMuch(other) && std::abs(apart_rad) > match_.options.weakHeadingSigma_rad;
  if (isElsewhere) turned_ = other;
  return isElsewhere;
}

/** Whether another pose explains the scans about as well, given the prior. */
bool JointConclusion::explainsAsMuch(const RefinedPose& other) const
{
  /** How much less likely a pose may be that explains the scans about as well. Unit: nat. Evidence:
   * one of them is right in one case of twenty. */
  constexpr double kAsLikely = 3;
  return other.score > 0 && other.logPosterior >= best_.logPosterior - kAsLikely;
}

void JointConclusion::takeHeadingOfGuess()
{
  result_.status = MatchStatus::Degenerate;
  result_.headingUnobservable = true;
  turned_.reset();
  scans_ = withoutHeading(accepted_.scans);
  result_.T_ref_cur = turnedTo(match_.guess.T_ref_cur.phi_rad, accepted_.T_ref_cur,
                               accepted_.scans.H, match_.unobservableSigma_m());
}

/** A direction in which the position is known badly is flagged; in which it is hardly known, the
 * position is that of the guess. */
void JointConclusion::settleDirection()
{
  const Observability o =
      result_.headingUnobservable ? observabilityAtHeading(scans_.H) : accepted_.observability;
  if (o.weakSigma_m <= match_.weakDirectionSigma_m()) return;
  result_.status = MatchStatus::Degenerate;
  if (o.weakSigma_m > match_.unobservableSigma_m())
    takePositionOfGuess(o.weakDirection);
  else
    result_.weakDirection = o.weakDirection;
}

void JointConclusion::takePositionOfGuess(const Eigen::Vector2d& direction)
{
  result_.unobservableDirection = direction;
  scans_ = withoutDirection(scans_, direction);
  const double moved_m =
      direction.dot(result_.T_ref_cur.translation() - match_.guess.T_ref_cur.translation());
  result_.T_ref_cur.x_m -= moved_m * direction.x();
  result_.T_ref_cur.y_m -= moved_m * direction.y();
}

/** The scans and the guess fused; of what is taken from the guess the variance is the guess's. */
void JointConclusion::settleCovariance()
{
  const Eigen::Matrix3d guess = match_.guessCovariance();
  result_.covariance = fusedCovariance(guess, scans_.H);
  if (result_.headingUnobservable)
  {
    Eigen::Vector3d turn;
    turn << positionPerHeading(scans_.H), 1;
    widen(turn, guess(2, 2) - result_.covariance(2, 2));
  }
  const Eigen::Vector2d u = openDirection();
  widen({u.x(), u.y(), 0}, u.dot((guess - result_.covariance).topLeftCorner<2, 2>() * u));
}

/** Adds an independent error along a direction of (x, y, phi). */
void JointConclusion::widen(const Eigen::Vector3d& direction, double variance)
{
  if (variance > 0) result_.covariance += variance * direction * direction.transpose();
}

/** Lists the distinct optima that explain the scans about as well, and mixes them into the
 * covariance. */
void JointConclusion::settleAmbiguity()
{
  std::vector<RefinedPose>& alternatives = match_.buffers.alternatives;
  alternatives.clear();
  for (const RefinedPose& other : match_.buffers.refinedPoses)
    if (isAmbiguousWith(other)) alternatives.push_back(other);
  if (turned_) alternatives.push_back(*turned_);
  keepDistinctOptima(alternatives, openDirection());
  if (alternatives.empty()) return;
  result_.status = MatchStatus::Degenerate;
  result_.ambiguity.emplace();
  result_.ambiguity->alternatives = static_cast<int>(alternatives.size());
  double sum = 1;
  for (const RefinedPose& other : alternatives) sum += relativeLikelihood(other);
  for (std::size_t i = 0; i < alternatives.size(); ++i)
    mixIn(alternatives[i], i, relativeLikelihood(alternatives[i]) / sum);
}

/** How likely a pose is beside the accepted one, at most as likely. */
double JointConclusion::relativeLikelihood(const RefinedPose& other) const
{
  return std::exp(std::min(0.0, other.logPosterior - accepted_.logPosterior));
}

void JointConclusion::mixIn(const RefinedPose& other, std::size_t rank, double weight)
{
  if (rank < result_.ambiguity->likeliest.size())
    result_.ambiguity->likeliest[rank] = {other.T_ref_cur, weight};
  Eigen::Vector3d apart = difference(result_.T_ref_cur, other.T_ref_cur);
  apart.head<2>() -= openDirection().dot(apart.head<2>()) * openDirection();
  widen(apart, weight);
}

/** Whether another pose explains as much, elsewhere than along a direction in which the position is
 * open anyway. */
bool JointConclusion::isAmbiguousWith(const RefinedPose& other) const
{
  return explainsAsMuch(other) && !verifier_.contradictsGuess(other) &&
         !isSameOptimum(accepted_.T_ref_cur, other.T_ref_cur, openDirection());
}

/** Along which the position is that of the guess; zero where there is no such direction. */
Eigen::Vector2d JointConclusion::openDirection() const
{
  return result_.unobservableDirection.value_or(Eigen::Vector2d::Zero());
}
}  // namespace psmks
