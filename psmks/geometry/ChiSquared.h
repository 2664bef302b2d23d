/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <array>
#include <cstddef>

namespace psmks
{
/** Squared Mahalanobis radius of a 95 % ellipse. Unit: chi2. Definition: the 0.95 quantile of the
 * chi-squared distribution with 2 degrees of freedom. */
constexpr double kChi2At95With2Dof = 5.991464547;

/** Squared Mahalanobis radius of a 95 % ellipsoid. Unit: chi2. Definition: the 0.95 quantile of the
 * chi-squared distribution with 3 degrees of freedom. */
constexpr double kChi2At95With3Dof = 7.814727903;

/** Squared Mahalanobis radius of a 99.9 % ellipsoid. Unit: chi2. Definition: the 0.999 quantile of
 * the chi-squared distribution with 3 degrees of freedom. */
constexpr double kChi2At999With3Dof = 16.26623620;

/** The value that is exceeded with a probability of 5 %, for 1 to 3 degrees of freedom. */
constexpr double chi2At95(int degreesOfFreedom)
{
  /** Squared Mahalanobis radii. Unit: chi2. Definition: the 0.95 quantiles of the chi-squared
   * distribution with 1 to 3 degrees of freedom. */
  constexpr std::array<double, 3> kQuantiles = {3.841458821, kChi2At95With2Dof, kChi2At95With3Dof};
  return kQuantiles[static_cast<std::size_t>(degreesOfFreedom - 1)];
}

/** The value that is exceeded with a probability of 0.1 %, for 1 to 3 degrees of freedom. */
constexpr double chi2At999(int degreesOfFreedom)
{
  /** Squared Mahalanobis radii. Unit: chi2. Definition: the 0.999 quantiles of the chi-squared
   * distribution with 1 to 3 degrees of freedom. */
  constexpr std::array<double, 3> kQuantiles = {10.82756617, 13.81551056, kChi2At999With3Dof};
  return kQuantiles[static_cast<std::size_t>(degreesOfFreedom - 1)];
}
}  // namespace psmks
