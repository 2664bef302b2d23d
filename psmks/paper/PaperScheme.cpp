/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/base/Stopwatch.h>
#include <psmks/features/FreeSpaceScore.h>
#include <psmks/paper/OrientationSearch.h>
#include <psmks/paper/PaperScheme.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
/** A pose and its matching error. */
struct Estimate
{
  Pose2 T_ref_cur;
  PoseObjective::Value value;
};

class PaperMatch
{
 public:
  PaperMatch(const Guess& guess, const PaperOptions& options, const ExternalSolvers* external,
             PaperBuffers& buffers, MatchTrace* trace)
      : guess_(guess), options_(options), external_(external), buffers_(buffers), trace_(trace)
  {
    result_.T_ref_cur = guess.T_ref_cur;
    if (guess.covariance && guess.covariance->allFinite()) result_.covariance = *guess.covariance;
  }

  MatchResult run()
  {
    Estimate estimate = evaluated(guess_.T_ref_cur);
    result_.errorBefore = result_.errorAfter = estimate.value.error;
    result_.associations = estimate.value.associations;
    result_.status = alternate(estimate);
    if (result_.usable()) conclude(estimate);
    return result_;
  }

 private:
  Estimate evaluated(const Pose2& T_ref_cur)
  {
    return {T_ref_cur, buffers_.objective.evaluate(T_ref_cur, T_ref_cur.phi_rad)};
  }

  /** Alternates orientation search and translation regression, and leaves the estimate at the best
   * pose. */
  MatchStatus alternate(Estimate& estimate)
  {
    while (result_.iterations < options_.maxIterations)
    {
      ++result_.iterations;
      const bool first = result_.iterations == 1;
      Estimate next = estimate;
      if (!turn(next)) return first ? MatchStatus::TooFewAssociations : MatchStatus::Converged;
      shift(next);
      const bool small = isSmall(estimate.T_ref_cur, next.T_ref_cur);
      const bool improved = buffers_.objective.isBetter(next.value, estimate.value);
      if (improved) estimate = next;
      if (small) return MatchStatus::Converged;
      if (!improved) return first ? MatchStatus::NoImprovement : MatchStatus::Converged;
    }
    return MatchStatus::MaxIterations;
  }

  /** Turns the estimate to the orientation with the smallest error.
   *  @return false if no orientation has enough associations */
  bool turn(Estimate& estimate)
  {
    Stopwatch watch;
    const OrientationMinimum minimum =
        searchOrientation(buffers_.objective, estimate.T_ref_cur, trace_);
    estimate.T_ref_cur.phi_rad = minimum.phi_rad;
    estimate.value = minimum.value;
    result_.times.search_s += watch.lap_s();
    note("orientation", estimate);
    return minimum.found;
  }

  /** Moves the estimate to the best of the steps tried along the direction of the regression. If
   * all of them are worse than no step, it stays. */
  void shift(Estimate& estimate)
  {
    Stopwatch watch;
    const PoseObjective& objective = buffers_.objective;
    const Pose2 start = estimate.T_ref_cur;
    // The regression needs the associations at the start; those at hand are of the pose tried last.
    evaluated(start);
    buildTranslationProblem(objective.projection(), objective.associations(),
                            objective.reliability(), options_.jacobian, buffers_.translation);
    Eigen::Vector2d step_m = translationStep_m();
    for (int halvings = 0; halvings <= options_.stepHalvings; ++halvings, step_m /= 2)
    {
      const Estimate tried =
          evaluated({start.x_m + step_m.x(), start.y_m + step_m.y(), start.phi_rad});
      if (objective.isBetter(tried.value, estimate.value)) estimate = tried;
    }
    result_.times.refinement_s += watch.lap_s();
    note("translation", estimate);
  }

  Eigen::Vector2d translationStep_m() const
  {
    const bool byCeres = options_.translationSolver == TranslationSolver::Ceres && external_;
    if (!byCeres) return solveTranslation(buffers_.translation);
    Eigen::Vector2d step_m = Eigen::Vector2d::Zero();
    external_->solveTranslation(buffers_.translation, step_m);
    return step_m;
  }

  bool isSmall(const Pose2& from, const Pose2& to) const
  {
    const double turned_rad = std::abs(wrapAngle(to.phi_rad - from.phi_rad));
    return (to.translation() - from.translation()).norm() <= options_.stopTranslation_m &&
           turned_rad <= options_.stopRotation_rad;
  }

  void note(const char* stage, const Estimate& e)
  {
    if (trace_)
      trace_->steps.push_back(
          {stage, e.T_ref_cur, e.value.error, std::nullopt, e.value.associations, e.value.refused});
  }

  // ---- conclusion -----------------------------------------------------------------------------

  /** Whether the residuals of the last evaluation are too large for a match. */
  bool hasLargeResiduals() const
  {
    const PoseObjective& objective = buffers_.objective;
    return options_.maxResidual_m > 0 &&
           rmsResidual_m(objective.associations(), objective.reliability()) >
               options_.maxResidual_m;
  }

  /** Refuses the estimate if its residuals are too large. Otherwise writes its covariance and its
   * unobservable direction to the result. */
  void conclude(const Estimate& estimate)
  {
    Stopwatch watch;
    const Estimate final = evaluated(estimate.T_ref_cur);
    if (hasLargeResiduals())
    {
      result_.status = MatchStatus::NoImprovement;
      return;
    }
    result_.T_ref_cur = estimate.T_ref_cur;
    result_.errorAfter = final.value.error;
    result_.associations = final.value.associations;
    buffers_.covariance.assign(buffers_.objective, estimate.T_ref_cur);
    finishCovariance(observability(buffers_.covariance.information()));
    result_.score = freeSpaceScoreAt(result_.T_ref_cur);
    result_.times.scoring_s += watch.lap_s();
  }

  void finishCovariance(const Observability& o)
  {
    const Eigen::Matrix3d guessed = result_.covariance;
    if (o.headingSigma_rad > options_.weakHeadingSigma_rad) takeHeadingOfGuess();
    if (o.weakSigma_m > options_.weakDirectionSigma_m)
      keepGuessAlong(o.weakDirection, guessed);
    else
      result_.covariance = buffers_.covariance.of(Eigen::Matrix3d::Identity());
    if (result_.headingUnobservable) widenHeading(guessed(2, 2) - result_.covariance(2, 2));
    if (!result_.covariance.allFinite()) result_.covariance = guessed;
  }

  void takeHeadingOfGuess()
  {
    result_.status = MatchStatus::Degenerate;
    result_.headingUnobservable = true;
    result_.T_ref_cur = turnedTo(guess_.T_ref_cur.phi_rad, result_.T_ref_cur,
                                 buffers_.covariance.information(), options_.weakDirectionSigma_m);
  }

  /** Adds an error of the heading, and of the position that goes with it. */
  void widenHeading(double variance_rad2)
  {
    if (!(variance_rad2 > 0)) return;
    Eigen::Vector3d turn;
    turn << positionPerHeading(buffers_.covariance.information(), options_.weakDirectionSigma_m), 1;
    result_.covariance += variance_rad2 * turn * turn.transpose();
  }

  /** Replaces the position along the direction that the scans do not constrain by that of the
   * guess. */
  void keepGuessAlong(const Eigen::Vector2d& weak, const Eigen::Matrix3d& guessed)
  {
    result_.status = MatchStatus::Degenerate;
    result_.unobservableDirection = weak;
    const Eigen::Vector2d moved_m =
        result_.T_ref_cur.translation() - guess_.T_ref_cur.translation();
    result_.T_ref_cur.x_m -= weak.dot(moved_m) * weak.x();
    result_.T_ref_cur.y_m -= weak.dot(moved_m) * weak.y();

    Eigen::Matrix<double, 3, 2> known;
    known << -weak.y(), 0, weak.x(), 0, 0, 1;
    const Eigen::Vector3d along(weak.x(), weak.y(), 0);
    result_.covariance =
        buffers_.covariance.of(known) + along.dot(guessed * along) * along * along.transpose();
  }

  double freeSpaceScoreAt(const Pose2& T_ref_cur)
  {
    ScanFeatures& reference = buffers_.reference;
    ScanFeatures& current = buffers_.current;
    reference.build(buffers_.objective.reference());
    current.build(buffers_.objective.current());
    const float tolerance_m = surfaceTolerance_m(
        std::max(reference.scan->typicalRangeSigma_m(), current.scan->typicalRangeSigma_m()));
    RayCounts counts = countRays(current.points, reference.surface, T_ref_cur, tolerance_m);
    counts += countRays(reference.points, current.surface, T_ref_cur.inverse(), tolerance_m);
    return freeSpaceScore(counts);
  }

  const Guess& guess_;
  const PaperOptions& options_;
  const ExternalSolvers* external_;
  PaperBuffers& buffers_;
  MatchTrace* trace_;
  MatchResult result_;
};

MatchResult invalidInput(const Guess& guess)
{
  MatchResult result;
  result.status = MatchStatus::InvalidInput;
  if (guess.T_ref_cur.isFinite()) result.T_ref_cur = guess.T_ref_cur;
  return result;
}
}  // namespace

MatchResult matchByPaperScheme(const SegmentedScan& reference, const SegmentedScan& current,
                               const Guess& guess, const PaperOptions& options,
                               const ExternalSolvers* external, PaperBuffers& buffers,
                               MatchTrace* trace)
{
  if (!guess.T_ref_cur.isFinite()) return invalidInput(guess);
  buffers.objective.assign(reference, current, options);
  return PaperMatch(guess, options, external, buffers, trace).run();
}
}  // namespace psmks
