/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/core/OrientationSearch.h>

#include <cmath>

namespace psmks
{
namespace
{
/** Steps of a size within a range, robust to the rounding of range / step. */
int stepsWithin(double range_rad, double step_rad)
{
  return static_cast<int>(std::floor(range_rad / step_rad + 1e-6));
}

void append(MatchTrace::OrientationCurve& curve, double phi_rad, const PoseObjective::Value& value)
{
  curve.phi_rad.push_back(phi_rad);
  curve.error.push_back(value.error);
  curve.associations.push_back(value.associations);
}

OrientationMinimum searchStage(PoseObjective& objective, const Pose2& start, double range_rad,
                               double step_rad, MatchTrace* trace)
{
  const PaperOptions& options = objective.options();
  OrientationMinimum best;
  best.phi_rad = start.phi_rad;
  MatchTrace::OrientationCurve curve;
  const int steps = stepsWithin(range_rad, step_rad);
  for (int k = -steps; k <= steps; ++k)
  {
    Pose2 tested = start;
    tested.phi_rad = wrapAngle(start.phi_rad + k * step_rad);
    const bool gateAtStart = options.gateOrientation == GateOrientation::Prior;
    const PoseObjective::Value value =
        objective.evaluate(tested, gateAtStart ? start.phi_rad : tested.phi_rad);
    if (trace) append(curve, tested.phi_rad, value);
    if (value.associations < options.minAssociations) continue;
    if (best.found && value.error >= best.value.error) continue;
    best = {true, tested.phi_rad, value};
  }
  if (trace) trace->orientationCurves.push_back(std::move(curve));
  return best;
}
}  // namespace

OrientationMinimum searchOrientation(PoseObjective& objective, const Pose2& start,
                                     MatchTrace* trace)
{
  const PaperOptions& o = objective.options();
  const OrientationMinimum coarse =
      searchStage(objective, start, o.coarseRange_rad, o.coarseStep_rad, trace);
  if (!coarse.found) return coarse;
  const Pose2 about{start.x_m, start.y_m, coarse.phi_rad};
  const OrientationMinimum fine =
      searchStage(objective, about, o.fineRange_rad, o.fineStep_rad, trace);
  return fine.found ? fine : coarse;
}
}  // namespace psmks
