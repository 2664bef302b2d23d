/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/RangeNoise.h>

#include <vector>

namespace psmks
{
/** How much ranges scatter, by the range. */
class RangeScatter
{
 public:
  /** The scatter of the ranges about one range. */
  struct Bin
  {
    double range_m = 0;  //!< mean of the ranges
    double sigma_m = 0;  //!< 68 % of the errors are smaller
    int errors = 0;
  };

  /** Counts an error of a range. One that is not finite, or of a range below 0, is left out. */
  void add(double range_m, double error_m);

  /** One for each metre of range in which there are at least 100 errors, the nearest first. */
  std::vector<Bin> bins() const;

  /** The noise sigma(r)^2 = sigma_m^2 + (sigmaPerMetre_m r)^2 that fits the bins best, by least
   * squares of the variances, each weighted with the number of its errors over its square; both
   * parts are at least 0. Zeros where there are no bins. */
  RangeNoise noise() const;

 private:
  struct Errors
  {
    double sumOfRanges_m = 0;
    std::vector<double> absolute_m;
  };

  std::vector<Errors> metres_;  //!< by the range in whole metres
};
}  // namespace psmks
