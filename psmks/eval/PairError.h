/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Angle.h>
#include <psmks/geometry/Pose2.h>
#include <psmks/match/MatchResult.h>

#include <Eigen/Core>

namespace psmks
{
/** The error of an estimated pose of the current scan. */
struct PairError
{
  double translation_m = 0;  //!< >= 0
  double rotation_rad = 0;   //!< >= 0; NaN where a heading is not known
};

/** The default limit of a success: both errors of a match must be below it. */
constexpr PairError kSuccessLimit{0.05, degToRad(1)};

/** An accepted match is wrong if an error exceeds this many times the limit of a success. */
constexpr double kWrongFactor = 2;

PairError pairError(const Pose2& T_ref_cur, const Pose2& T_ref_cur_true);

/** Whether both errors are below the limit; a rotation that is not known counts as such. */
bool isSuccess(const PairError& error, const PairError& limit = kSuccessLimit);

/** Whether a match was reported as usable, without an unobservable direction, and yet is wrong.
 *  @param limit of a success */
bool isAcceptedAndWrong(MatchStatus status, const PairError& error,
                        const PairError& limit = kSuccessLimit);

/** Normalised estimation error squared, e' C^-1 e with e = (dx, dy, dphi) in the axes of the
 * reference. Its mean is 3 if the covariance is right.
 *  @return NaN if the covariance is not positive definite */
double nees(const Pose2& T_ref_cur, const Eigen::Matrix3d& covariance, const Pose2& T_ref_cur_true);
}  // namespace psmks
