/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

namespace psmks
{
/** Values of the chi-squared distribution that are exceeded with a probability of 5 % or 0.1 %, for
 * 2 and 3 degrees of freedom: the squared radius of a 95 % ellipse, and of 95 % and 99.9 %
 * ellipsoids. */
constexpr double kChi2At95With2Dof = 5.991464547;
constexpr double kChi2At95With3Dof = 7.814727903;
constexpr double kChi2At999With3Dof = 16.26623620;
}  // namespace psmks
