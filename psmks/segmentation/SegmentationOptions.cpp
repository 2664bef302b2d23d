/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/geometry/Angle.h>
#include <psmks/segmentation/SegmentationOptions.h>

namespace psmks
{
void listFields(OptionTable& table, PreprocessingOptions& o)
{
  table.beginSection("preprocessing", "Which rays are used.");
  table.add("min_range_m", o.minRange_m, Unit::Metre, 0, 100,
            "readings at or below it are invalid");
  table.add("max_range_m", o.maxRange_m, Unit::Metre, 0, 1000,
            "readings at or beyond it are no returns; 0: the scan's own limit");
  table.add(
      "median_window", o.medianWindow, 0, 31,
      "rays of a median filter over the ranges; 0: off, because it cuts corners and correlates "
      "the noise that the line fit takes for independent");
}

void listFields(OptionTable& table, SegmentationOptions& o)
{
  table.beginSection("segmentation", "Kalman Segmentation: straight lines from consecutive rays.");
  table.add("filter", o.filter, {"linear", "ekf"},
            "linear: information form of 1/r = u.(cos, sin) finished by Gauss-Newton; ekf: the "
            "paper's extended Kalman filter on (r0, phi0)");
  table.add("range_sigma_m", o.rangeSigma_m, Unit::Metre, 1e-4, 1,
            "standard deviation of a range, where the scan does not state its own");
  table.add("range_sigma_per_metre_m", o.rangeSigmaPerMetre_m, Unit::Metre, 0, 0.2,
            "and what every metre of the range adds to it, in squares");
  table.add("estimate_range_sigma", o.estimateRangeSigma,
            "raise the standard deviation to what the scan itself shows, with its growth and "
            "coarse steps; half a step is taken off ranges that a simulator rounded up");
  table.add("innovation_gate", o.innovationGate, Unit::None, 1, 20,
            "standard deviations within which a ray continues a line");
  table.add("seed_rays", o.seedRays, 3, 20, "consecutive rays that start a line");
  table.add("min_rays", o.minRays, 3, 100, "fewer rays are no segment and stay single points");
  table.add("corner_reach", o.cornerReach, 0, 100,
            "rays on either side of a corner for which the two lines compete");
  table.add("merge_chi2", o.mergeChi2, Unit::None, 0, 1e3,
            "rise of chi2 (2 degrees of freedom) below which collinear neighbours become one");
  table.add("max_reduced_chi2", o.maxReducedChi2, Unit::None, 1, 1e3,
            "chi2 per degree of freedom above which rays are too noisy to be a segment");
  table.add("curvature_gate", o.curvatureGate, Unit::None, 1, 1e3,
            "standard deviations of the quadratic term above which rays are a curve, no segment");
  table.add("min_incidence_cosine", o.minIncidenceCosine, Unit::None, 0, 0.9,
            "rays that graze a line at a smaller cosine do not support it");
  table.add("max_offset_sigma_m", o.maxOffsetSigma_m, Unit::Metre, 1e-4, 10,
            "a line known worse across its middle is no segment");
  table.add("max_angle_sigma_deg", o.maxAngleSigma_rad, Unit::Degree, 0, degToRad(90),
            "a line whose direction is known worse is no segment");
}
}  // namespace psmks
