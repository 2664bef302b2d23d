/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <Eigen/Core>

namespace psmks
{
/** Whether a matrix is the covariance of a pose (x, y, phi): finite, symmetric up to the rounding
 * of doubles, and positive definite. */
bool isCovariance(const Eigen::Matrix3d& matrix);

/** The covariance of a pose (x, y, phi), m^2, m rad, rad^2, as a double can hold it: symmetric to
 * the last bit, and with eigenvalues that are
 *
 *  - at most kVaguest, as where nothing is known,
 *  - at least kSharpest, and at least 1e-14 of the largest one, for a double keeps no digit of what
 *    is smaller.
 *
 * The result is positive definite in computation, too: its Cholesky and its eigenvalue
 * decomposition succeed. A covariance within these bounds is only made symmetric.
 *  @param covariance finite, positive semidefinite up to rounding
 *  @return zero, and not bounded, where the covariance is zero */
Eigen::Matrix3d boundedCovariance(const Eigen::Matrix3d& covariance);

/** Variance of a pose of which nothing is known. Unit: m^2, rad^2. Definition: a kilometre. */
constexpr double kVaguest = 1e6;

/** Least variance. Unit: m^2, rad^2. Definition: a nanometre. */
constexpr double kSharpest = 1e-18;
}  // namespace psmks
