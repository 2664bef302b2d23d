/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Angle.h>
#include <psmks/geometry/Pose2.h>
#include <psmks/match/MatchResult.h>

#include <Eigen/Core>

namespace psmks
{
/** How far an estimated pose of the current scan is from the true one. */
struct PairError
{
  double translation_m = 0;  //!< >= 0
  double rotation_rad = 0;   //!< >= 0
};

/** A matched pair is a success below both of these, where nothing else is said. */
constexpr PairError kSuccessLimit{0.05, degToRad(1)};

/** An accepted pair is wrong above so many times either limit of a success. */
constexpr double kWrongFactor = 2;

PairError pairError(const Pose2& T_ref_cur, const Pose2& T_ref_cur_true);

bool isSuccess(const PairError& error, const PairError& limit = kSuccessLimit);

/** True where a caller was told to trust the pose without reserve (usable, and no direction flagged
 *  as not observable) and should not have.
 *  @param limit of a success */
bool isAcceptedAndWrong(MatchStatus status, const PairError& error,
                        const PairError& limit = kSuccessLimit);

/** Normalised estimation error squared, e' C^-1 e with e = (dx, dy, dphi) in reference axes: 3 on
 *  average where the covariance is right. NaN where the covariance is not positive definite. */
double nees(const Pose2& T_ref_cur, const Eigen::Matrix3d& covariance, const Pose2& T_ref_cur_true);
}  // namespace psmks
