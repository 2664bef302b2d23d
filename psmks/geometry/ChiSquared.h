/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

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
}  // namespace psmks
