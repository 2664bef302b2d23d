/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/base/Stopwatch.h>
#include <psmks/geometry/Innovation.h>
#include <psmks/geometry/Observability.h>
#include <psmks/geometry/UncertainPose.h>
#include <psmks/joint/OpenDirections.h>
#include <psmks/mrpt/MapMatch.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace psmks
{
namespace
{
/** Every point of a map, or one of so many. */
std::vector<Eigen::Vector2d> decimated(const std::vector<Eigen::Vector2d>& points_m, int every)
{
  std::vector<Eigen::Vector2d> kept;
  for (std::size_t i = 0; i < points_m.size(); i += static_cast<std::size_t>(every))
    kept.push_back(points_m[i]);
  return kept;
}

/** Fills a field with points, whose frame is moved to `origin_m`. */
void fill(SurfaceField& field, const std::vector<Eigen::Vector2d>& points_m,
          const Eigen::Vector2d& origin_m)
{
  field.clear();
  for (const Eigen::Vector2d& point_m : points_m) field.add(point_m - origin_m);
}

/** Standard deviation of the points of a map about the surfaces that they show themselves: the
 * median over the points, for corners and thickets spread more.
 *  @param field memory */
double pointSigma(const MapPoints& map, SurfaceField& field)
{
  /** Limits of the standard deviation: walls are not even to less, and what spreads more is no
   * surface. Unit: m. Evidence: open. */
  constexpr double kLeast_m = 0.01, kMost_m = 0.1;
  constexpr int kCoarsest = 1;   // windows of 0.42 m, in which a wall is straight
  constexpr double kFitted = 2;  // a line has two parameters, which points adapt to
  constexpr int kFewest = 4;
  fill(field, map.points_m, Eigen::Vector2d::Zero());
  std::vector<double> variances_m2;
  for (const Eigen::Vector2d& point_m : map.points_m)
    if (const Surface* s = field.finestAt(point_m, 0, kCoarsest); s && s->points >= kFewest)
      variances_m2.push_back(s->acrossVariance_m2 * s->points / (s->points - kFitted));
  if (variances_m2.empty()) return kLeast_m;
  const auto median = variances_m2.begin() + static_cast<std::ptrdiff_t>(variances_m2.size() / 2);
  std::nth_element(variances_m2.begin(), median, variances_m2.end());
  return std::clamp(std::sqrt(*median), kLeast_m, kMost_m);
}

/** What a guess says of an accepted registration, and what the maps leave to it. */
class MapConclusion
{
 public:
  MapConclusion(const Guess& guess, const JointOptions& limits,
                const Eigen::Matrix3d& openCovariance, double pointSigma_m, MatchResult& result)
      : guess_(guess),
        limits_(limits),
        least_m_(kOfPoint * pointSigma_m),
        prior_(guess.covariance.value_or(MatchResult::unknownCovariance())),
        open_(guess.covariance.value_or(openCovariance)),
        result_(result)
  {
  }

  void conclude(const Registration& best)
  {
    result_.status = best.converged ? MatchStatus::Converged : MatchStatus::MaxIterations;
    result_.T_ref_cur = best.T_map_points;
    maps_.H = best.information;
    settleHeading();
    settleDirection();
    result_.covariance = fusedCovariance(prior_, maps_.H);
    if (guess_.covariance) compareWithGuess();
  }

 private:
  /** A direction is open or weak only where it is known worse than so many standard deviations of a
   * point. Unit: standard deviations. Evidence: as in the joint scheme. */
  static constexpr double kOfPoint = 1.5;

  void settleHeading()
  {
    if (observability(maps_.H).headingSigma_rad <= limits_.weakHeadingSigma_rad) return;
    result_.status = MatchStatus::Degenerate;
    result_.headingUnobservable = true;
    result_.T_ref_cur = turnedTo(guess_.T_ref_cur.phi_rad, result_.T_ref_cur, maps_.H,
                                 std::numeric_limits<double>::infinity());
    maps_ = withoutHeading(maps_);
    prior_(2, 2) = open_(2, 2);
  }

  void settleDirection()
  {
    const Observability known =
        result_.headingUnobservable ? observabilityAtHeading(maps_.H) : observability(maps_.H);
    if (known.weakSigma_m <= std::max(limits_.weakDirectionSigma_m, least_m_)) return;
    result_.status = MatchStatus::Degenerate;
    if (known.weakSigma_m > std::max(limits_.unobservableSigma_m, least_m_))
      takePositionOfGuess(known.weakDirection);
    else
      result_.weakDirection = known.weakDirection;
  }

  void takePositionOfGuess(const Eigen::Vector2d& u)
  {
    result_.unobservableDirection = u;
    maps_ = withoutDirection(maps_, u);
    const Eigen::Vector2d away = guess_.T_ref_cur.translation() - result_.T_ref_cur.translation();
    result_.T_ref_cur.x_m += u.dot(away) * u.x();
    result_.T_ref_cur.y_m += u.dot(away) * u.y();
    const Eigen::Matrix2d difference = (open_ - prior_).topLeftCorner<2, 2>();
    prior_.topLeftCorner<2, 2>() += u.dot(difference * u) * u * u.transpose();
  }

  /** The gradient of the likelihood of the maps is that of the prior, for their sum is at its
   *  optimum. */
  void compareWithGuess()
  {
    const Pose2 &T = result_.T_ref_cur, &guess = guess_.T_ref_cur;
    const Eigen::Vector3d away(T.x_m - guess.x_m, T.y_m - guess.y_m,
                               wrapAngle(T.phi_rad - guess.phi_rad));
    result_.innovation =
        innovation({guess, *guess_.covariance}, T, maps_.H, guess_.covariance->inverse() * away);
  }

  const Guess& guess_;
  const JointOptions& limits_;
  double least_m_;
  Eigen::Matrix3d prior_;  //!< of the estimate
  Eigen::Matrix3d open_;   //!< of what is taken from the guess
  NormalEquations maps_;
  MatchResult& result_;
};
}  // namespace

MatchResult MapMatch::match(const MapPoints& reference, const MapPoints& current,
                            const Guess& guess, SurfaceField& field, const Proposer& propose) const
{
  Stopwatch watch;
  MatchResult result;
  result.status = MatchStatus::InvalidInput;
  result.covariance = guess.covariance.value_or(openCovariance_);
  if (!guess.T_ref_cur.isFinite()) return result;
  result.T_ref_cur = guess.T_ref_cur;
  if (reference.points_m.empty() || current.points_m.empty()) return result;

  const double sigma_m = std::hypot(std::max(pointSigma(current, field), current.cellSigma_m()),
                                    reference.cellSigma_m());
  const Eigen::Vector2d origin_m = guess.T_ref_cur.translation();
  fill(field, reference.points_m, origin_m);
  const auto points_m = decimated(current.points_m, options_.corresponding_points_decimation);
  MapRegistration registration(points_m, sigma_m, field, origin_m, options_);
  const Registration best = bestRegistration(registration, guess, propose, result);
  result.times.refinement_s = watch.lap_s() - result.times.search_s;
  conclude(best, guess, sigma_m, result);
  return result;
}

Registration MapMatch::bestRegistration(MapRegistration& registration, const Guess& guess,
                                        const Proposer& propose, MatchResult& result) const
{
  /** Share of explained points from which on no other pose is looked for. Evidence: measured. */
  constexpr double kConvincing = 0.8;
  /** How far a proposed pose may be off. Unit: m. Evidence: open. */
  constexpr double kProposed_m = 0.12;
  std::optional<MapRegistration::Prior> prior;
  if (guess.covariance) prior = {guess.T_ref_cur, *guess.covariance};
  const Registration best = registration.refine(guess.T_ref_cur, prior, options_.thresholdDist);
  result.hypotheses = 1;
  result.iterations = best.iterations;
  if (best.explainedShare() >= kConvincing) return best;

  Stopwatch watch;
  const std::optional<Pose2> proposed = propose();
  result.times.search_s = watch.lap_s();
  if (!proposed) return best;
  const Registration other = registration.refine(*proposed, prior, kProposed_m);
  ++result.hypotheses;
  result.iterations += other.iterations;
  return other.logLikelihood > best.logLikelihood ? other : best;
}

void MapMatch::conclude(const Registration& best, const Guess& guess, double pointSigma_m,
                        MatchResult& result) const
{
  result.associations = best.explained;
  result.score = best.explainedShare();
  if (best.explained < limits_.minAssociations)
    result.status = MatchStatus::TooFewAssociations;
  else if (result.score < limits_.acceptScore)
    result.status = MatchStatus::NoImprovement;
  else
    MapConclusion(guess, limits_, openCovariance_, pointSigma_m, result).conclude(best);
}
}  // namespace psmks
