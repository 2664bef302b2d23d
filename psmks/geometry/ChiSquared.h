/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

namespace psmks
{
/** Quantiles of the chi-squared distribution with 2 and 3 degrees of freedom at 95 % and 99.9 %: a
 * squared Mahalanobis distance exceeds them with a probability of 5 % and 0.1 %. */
constexpr double kChi2At95With2Dof = 5.991464547;
constexpr double kChi2At95With3Dof = 7.814727903;
constexpr double kChi2At999With3Dof = 16.26623620;
}  // namespace psmks
