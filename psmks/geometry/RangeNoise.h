/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <cmath>

namespace psmks
{
/** How uncertain a range is: a part that all ranges share and a part in proportion to the range,
 * independent of each other,
 *
 *     sigma(r)^2 = sigma_m^2 + (sigmaPerMetre_m r)^2.
 *
 * The first is what time of flight scanners have, the second that of phase shift; triangulation
 * comes near to it within its range. */
struct RangeNoise
{
  double sigma_m = 0;          //!< standard deviation of a short range; 0 = unknown
  double sigmaPerMetre_m = 0;  //!< 0 = all ranges alike

  bool grows() const { return sigmaPerMetre_m > 0; }

  double varianceAt_m2(double range_m) const
  {
    const double grown_m = sigmaPerMetre_m * range_m;
    return sigma_m * sigma_m + grown_m * grown_m;
  }
  double sigmaAt_m(double range_m) const { return std::sqrt(varianceAt_m2(range_m)); }

  /** Of a variance, which is sigma_m^2 (1 + growth r^2). Both sigmas > 0 or no growth. */
  double growth_1_m2() const
  {
    if (!grows()) return 0;
    const double ratio_1_m = sigmaPerMetre_m / sigma_m;
    return ratio_1_m * ratio_1_m;
  }

  /** Of a range in a sum of squares that is kept for short ranges. */
  double weightAt(double range_m) const { return sigma_m * sigma_m / varianceAt_m2(range_m); }

  /** The same growth, with the standard deviation of a short range as it is given. */
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
