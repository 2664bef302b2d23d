/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/paper/PaperOptions.h>

namespace psmks
{
// NOLINTNEXTLINE(readability-function-size): one line an option
void listFields(OptionTable& table, PaperOptions& o)
{
  table.beginSection("paper", "The paper's scheme: association, orientation search, translation.");
  table.add("radius_gate_m", o.radiusGate_m, Unit::Metre, 1e-3, 10,
            "lines whose r0 differ by less may be the same object");
  table.add("angle_gate_deg", o.angleGate_rad, Unit::Degree, 0, degToRad(90),
            "lines whose phi0 differ by less may be the same object");
  table.add("mahalanobis_gate", o.mahalanobisGate, Unit::None, 0, 100,
            "standard deviations within which two lines may be the same object; 0: off");
  table.add("gate_orientation", o.gateOrientation, {"prior", "tested"},
            "orientation at which angle_gate_deg is tested: the one held before a search stage, or "
            "each one tried");
  table.add("min_associations", o.minAssociations, 1, 100000,
            "fewer associated rays fail the match");
  table.add(
      "min_association_share", o.minAssociationShare, Unit::None, 0, 1,
      "a pose that associates a smaller share of the rays that another does is the worse one, "
      "whatever its error; 0: off");
  table.add("max_residual_m", o.maxResidual_m, Unit::Metre, 0, 100,
            "a larger root mean square residual at the end fails the match; 0: off");
  table.add("coarse_range_deg", o.coarseRange_rad, Unit::Degree, 0, degToRad(180),
            "half width of the coarse orientation search");
  table.add("coarse_step_deg", o.coarseStep_rad, Unit::Degree, degToRad(1e-3), degToRad(45),
            "step of the coarse orientation search");
  table.add("fine_range_deg", o.fineRange_rad, Unit::Degree, 0, degToRad(45),
            "half width of the fine search about the coarse minimum");
  table.add("fine_step_deg", o.fineStep_rad, Unit::Degree, degToRad(1e-4), degToRad(45),
            "step of the fine orientation search");
  table.add("jacobian", o.jacobian, {"frozen-bearing", "full"},
            "of the translation regression; frozen-bearing: the paper's");
  table.add("translation_solver", o.translationSolver, {"closed-form", "ceres"},
            "who solves the translation regression");
  table.add("step_halvings", o.stepHalvings, 0, 10,
            "a translation step is tried at its length, half of it, a quarter ..., so many times "
            "halved");
  table.add("max_iterations", o.maxIterations, 1, 1000,
            "alternations of orientation search and translation regression");
  table.add("stop_translation_m", o.stopTranslation_m, Unit::Metre, 0, 1,
            "converged when a translation step is shorter and the rotation step below its limit");
  table.add("stop_rotation_deg", o.stopRotation_rad, Unit::Degree, 0, degToRad(45),
            "see stop_translation_m");
  table.add("weak_direction_sigma_m", o.weakDirectionSigma_m, Unit::Metre, 1e-4, 10,
            "a direction in which the segments fix the position worse is not observable");
  table.add("weak_heading_sigma_deg", o.weakHeadingSigma_rad, Unit::Degree, degToRad(1e-3),
            degToRad(180), "a heading that the segments fix worse is not observable");
}
}  // namespace psmks
