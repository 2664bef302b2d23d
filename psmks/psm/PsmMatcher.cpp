/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/psm/PsmCovariance.h>
#include <psmks/psm/PsmMatchError.h>
#include <psmks/psm/PsmMatcher.h>
#include <psmks/psm/PsmOrientation.h>
#include <psmks/psm/PsmTranslation.h>

#include <cmath>
#include <limits>

namespace psmks
{
class PsmMatcher::Run
{
 public:
  Run(PsmMatcher& matcher, const PsmScan& reference, const PsmScan& current, const Pose2& guess)
      : options_(matcher.options_),
        projection_(matcher.projection_),
        turnErrors_m_(matcher.turnErrors_m_),
        reference_(reference),
        current_(current),
        guess_(guess),
        T_ref_cur_(guess)
  {
  }

  PsmResult result()
  {
    result_.status = alternate();
    if (result_.usable()) result_.status = evaluateFinalPose();
    result_.T_ref_cur = result_.usable() ? T_ref_cur_ : guess_;
    return result_;
  }

 private:
  PsmStatus alternate()
  {
    int smallSteps = 0;
    while (result_.iterations < options_.maxIterations)
    {
      project();
      const bool orientationIsNext = result_.iterations % 2 == 0;
      ++result_.iterations;
      const PsmStatus status = orientationIsNext ? turn() : shift();
      if (status != PsmStatus::Converged) return status;
      smallSteps = lastStepsAreSmall() ? smallSteps + 1 : 0;
      if (smallSteps == options_.smallStepsToStop) return PsmStatus::Converged;
    }
    return PsmStatus::MaxIterations;
  }

  void project() { projectPsmScan(current_, T_ref_cur_, reference_.grid, projection_); }

  /** Orientation search. The status says whether the step could be made, as that of shift(). */
  PsmStatus turn()
  {
    const auto turn_rad =
        findPsmTurn_rad(reference_, projection_, options_.searchWindow_rad, turnErrors_m_);
    if (!turn_rad) return PsmStatus::TooFewPairs;
    lastTurn_rad_ = *turn_rad;
    T_ref_cur_.phi_rad = wrapAngle(T_ref_cur_.phi_rad + *turn_rad);
    return PsmStatus::Converged;
  }

  PsmStatus shift()
  {
    const bool late = result_.iterations > options_.lateFromIteration;
    const PsmTranslation translation =
        solvePsmTranslation(reference_, projection_,
                            late ? options_.lateWeightScale_m : options_.weightScale_m, options_);
    result_.pairs = translation.pairs;
    if (translation.pairs * reference_.grid.increment_rad() < options_.minPairedArc_rad)
      return PsmStatus::TooFewPairs;
    if (!translation.solvable) return PsmStatus::Singular;
    lastShift_m_ = translation.step_m.lpNorm<1>();
    T_ref_cur_.x_m += translation.step_m.x();
    T_ref_cur_.y_m += translation.step_m.y();
    return PsmStatus::Converged;
  }

  bool lastStepsAreSmall() const
  {
    return lastShift_m_ / options_.stopTranslation_m +
               std::abs(lastTurn_rad_) / options_.stopRotation_rad <
           1;
  }

  /** Computes the error index and the covariance of the final pose. */
  PsmStatus evaluateFinalPose()
  {
    result_.errorIndex_m = errorIndex_m();
    if (!std::isfinite(result_.errorIndex_m) || !T_ref_cur_.isFinite())
      return PsmStatus::TooFewPairs;
    result_.covariance = psmCovariance(reference_, result_.errorIndex_m, options_);
    return result_.status;
  }

  double errorIndex_m()
  {
    if (options_.errorIndex == PsmErrorIndex::NearestPoint)
      return pointErrorIndex_m(reference_, current_, T_ref_cur_);
    project();
    return rangeErrorIndex_m(reference_, projection_, options_.maxPairDifference_m);
  }

  const PsmOptions& options_;
  PsmProjection& projection_;
  std::vector<double>& turnErrors_m_;
  const PsmScan& reference_;
  const PsmScan& current_;
  const Pose2 guess_;
  Pose2 T_ref_cur_;
  double lastTurn_rad_ = std::numeric_limits<double>::infinity();
  double lastShift_m_ = std::numeric_limits<double>::infinity();
  PsmResult result_;
};

PsmResult PsmMatcher::match(const PsmScan& reference, const PsmScan& current,
                            const Pose2& T_ref_cur_guess)
{
  if (T_ref_cur_guess.isFinite() && reference.goodRays() > 0 && current.goodRays() > 0)
    return Run(*this, reference, current, T_ref_cur_guess).result();
  PsmResult result;
  result.status = PsmStatus::InvalidInput;
  if (T_ref_cur_guess.isFinite()) result.T_ref_cur = T_ref_cur_guess;
  return result;
}
}  // namespace psmks
