/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <cmath>

namespace psmks
{
/** The standard deviation of a range as a function of the range. Two independent parts add up, a
 * constant one and one in proportion to the range r:
 *
 *     sigma(r)^2 = sigma_m^2 + (sigmaPerMetre_m r)^2.
 *
 * Time-of-flight scanners have mostly the first part, phase-shift scanners the second. The model
 * approximates triangulation scanners within their specified range. */
struct RangeNoise
{
  double sigma_m = 0;  //!< standard deviation at range 0; 0 = unknown
  /** Growth of the standard deviation, metres for each metre of range; 0 = the noise is the same at
   * all ranges. */
  double sigmaPerMetre_m = 0;

  bool grows() const { return sigmaPerMetre_m > 0; }

  double varianceAt_m2(double range_m) const
  {
    const double grown_m = sigmaPerMetre_m * range_m;
    return sigma_m * sigma_m + grown_m * grown_m;
  }
  double sigmaAt_m(double range_m) const { return std::sqrt(varianceAt_m2(range_m)); }

  /** The factor g of r^2 in the variance, written as sigma_m^2 (1 + g r^2), in 1/m^2: `_1_m2` in a
   * name stands for 1/m^2, as `_1_m` does for 1/m. It needs sigma_m > 0 unless the noise does not
   * grow. */
  double growth_1_m2() const
  {
    if (!grows()) return 0;
    const double ratio_1_m = sigmaPerMetre_m / sigma_m;
    return ratio_1_m * ratio_1_m;
  }

  /** The weight of a range in a sum of squares that is divided by sigma_m^2 as a whole: the
   * variance at range 0 over the variance at this range. */
  double weightAt(double range_m) const { return sigma_m * sigma_m / varianceAt_m2(range_m); }

  /** The noise with another standard deviation at range 0 and the same ratio of the two parts. */
  RangeNoise scaledTo(double newSigma_m) const
  {
    return {newSigma_m, sigmaPerMetre_m * newSigma_m / sigma_m};
  }

  bool operator!=(const RangeNoise& other) const
  {
    return sigma_m != other.sigma_m || sigmaPerMetre_m != other.sigmaPerMetre_m;
  }
};
}  // namespace psmks
