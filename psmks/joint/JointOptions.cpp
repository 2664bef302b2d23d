/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/joint/JointOptions.h>

namespace psmks
{
namespace
{
void listSearch(OptionTable& table, JointOptions& o)
{
  table.add("search_radius_m", o.searchRadius_m, Unit::Metre, 0.01, 10,
            "displacement from the guess that is searched");
  table.add("search_angle_deg", o.searchAngle_rad, Unit::Degree, degToRad(1), degToRad(180),
            "rotation from the guess that is searched, to either side");
  table.add("wide_radius_m", o.wideRadius_m, Unit::Metre, 0, 20,
            "displacement that is searched where the best pose nearer to the guess is doubtful, if "
            "the guess "
            "was not measured; 0: none, nor is a measured one ever given up");
  table.add(
      "wide_angle_deg", o.wideAngle_rad, Unit::Degree, 0, degToRad(180),
      "rotation that is searched then, to either side, and where a measured guess is given up");
  table.add("voted_angles", o.votedAngles, 1, 36,
            "peaks of the vote of segment angles that are followed");
  table.add("refined_hypotheses", o.refinedHypotheses, 1, 100,
            "starts that each search refines at most; the wide one twice as many");
  table.add("confident_score", o.confidentScore, Unit::None, 0, 1,
            "free-space score from which no further start is tried");
  table.add("agreed_score", o.agreedScore, Unit::None, 0, 1,
            "the same for a pose that agrees with a guess that has a covariance, by the 95 % "
            "ellipsoid of their difference");
}

void listRefinement(OptionTable& table, JointOptions& o)
{
  table.add(
      "distance_gate_m", o.distanceGate_m, Unit::Metre, 1e-3, 10,
      "lines farther apart are not associated, first association; halved at each further one, "
      "a quarter at the last, but for noise");
  table.add("angle_gate_deg", o.angleGate_rad, Unit::Degree, 0, degToRad(90),
            "lines at a larger angle are not associated, first association; halved at each further "
            "one, a quarter at the last");
  table.add("kernel_width", o.kernelWidth, Unit::None, 0.1, 1e3,
            "standard deviations at which a whole line pair begins to lose its weight (Cauchy)");
  table.add("single_ray_weight", o.singleRayWeight, Unit::None, 0, 1,
            "weight of rays that belong to no segment");
  table.add("reassociations", o.reassociations, 1, 20, "associations in one refinement");
  table.add("max_iterations", o.maxIterations, 1, 1000, "Gauss-Newton steps per association");
  table.add("stop_translation_m", o.stopTranslation_m, Unit::Metre, 0, 1,
            "converged when a step is shorter and the rotation step below its limit");
  table.add("stop_rotation_deg", o.stopRotation_rad, Unit::Degree, 0, degToRad(45),
            "see stop_translation_m");
  table.add("solver", o.solver, {"gauss-newton", "ceres"}, "who solves the joint step");
}

void listAcceptance(OptionTable& table, JointOptions& o)
{
  table.add("min_associations", o.minAssociations, 1, 100000,
            "fewer associated rays fail the match");
  table.add(
      "accept_score", o.acceptScore, Unit::None, 0, 1,
      "a pose with a lower free-space score is refused; half of it is enough where a measured "
      "guess agrees with the pose, 0.15 more is needed where it contradicts it");
  table.add("weak_direction_sigma_m", o.weakDirectionSigma_m, Unit::Metre, 1e-4, 10,
            "a direction in which the scans fix the position worse is weakly observable; at least "
            "1.5 times the standard deviation of a range");
  table.add("unobservable_sigma_m", o.unobservableSigma_m, Unit::Metre, 1e-4, 10,
            "a direction in which the scans fix the position worse is not observable: along it the "
            "pose is the guess; at least weak_direction_sigma_m");
  table.add("weak_heading_sigma_deg", o.weakHeadingSigma_rad, Unit::Degree, degToRad(1e-3),
            degToRad(180), "a heading that the scans fix worse is not observable");
}
}  // namespace

void listFields(OptionTable& table, JointOptions& options)
{
  table.beginSection("joint", "The joint scheme: hypotheses, refinement and acceptance.");
  listSearch(table, options);
  listRefinement(table, options);
  listAcceptance(table, options);
}
}  // namespace psmks
