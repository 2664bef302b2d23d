/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/paper/OrientationSearch.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
/** How many steps of a size fit into a range. */
int stepsWithin(double range_rad, double step_rad)
{
  /** A step that exceeds the range by less still fits. Unit: steps. Definition: the rounding of the
   * quotient of two angles. */
  constexpr double kRounding = 1e-6;
  return static_cast<int>(std::floor(range_rad / step_rad + kRounding));
}

using Trials = std::vector<PoseObjective::Trial>;

void tryAbout(PoseObjective& objective, const Pose2& start, double range_rad, double step_rad)
{
  const bool gateAtStart = objective.options().gateOrientation == GateOrientation::Prior;
  const int steps = stepsWithin(range_rad, step_rad);
  Trials& trials = objective.trials();
  trials.clear();
  for (int k = -steps; k <= steps; ++k)
  {
    Pose2 tested = start;
    tested.phi_rad = wrapAngle(start.phi_rad + k * step_rad);
    const double gateOrientation_rad = gateAtStart ? start.phi_rad : tested.phi_rad;
    trials.push_back({tested.phi_rad, objective.evaluate(tested, gateOrientation_rad)});
  }
}

/** The smallest error among the orientations that associate nearly as many rays as any. */
OrientationMinimum minimumOf(const Trials& trials, const PaperOptions& options)
{
  int most = 0;
  for (const auto& trial : trials) most = std::max(most, trial.value.associations);
  const double enough =
      std::max<double>(options.minAssociations, options.minAssociationShare * most);
  OrientationMinimum best;
  for (const auto& trial : trials)
  {
    if (trial.value.associations < enough) continue;
    if (best.found && trial.value.error >= best.value.error) continue;
    best = {true, trial.phi_rad, trial.value};
  }
  return best;
}

MatchTrace::OrientationCurve curveOf(const Trials& trials)
{
  MatchTrace::OrientationCurve curve;
  for (const auto& trial : trials)
  {
    curve.phi_rad.push_back(trial.phi_rad);
    curve.error.push_back(trial.value.error);
    curve.associations.push_back(trial.value.associations);
  }
  return curve;
}

OrientationMinimum searchStage(PoseObjective& objective, const Pose2& start, double range_rad,
                               double step_rad, MatchTrace* trace)
{
  tryAbout(objective, start, range_rad, step_rad);
  if (trace) trace->orientationCurves.push_back(curveOf(objective.trials()));
  OrientationMinimum minimum = minimumOf(objective.trials(), objective.options());
  if (!minimum.found) minimum.phi_rad = start.phi_rad;
  return minimum;
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
