/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/base/OptionTable.h>
#include <psmks/geometry/Angle.h>
#include <psmks/geometry/Pose2.h>

#include <Eigen/Core>

namespace psmks
{
/** How far a motion measured by wheels is trusted, and what is assumed where none was measured.
 *  Standard deviations; a turn is 360 degrees. */
struct OdometryOptions
{
  double minSigma_m = 0.02;
  double minSigma_rad = degToRad(1);
  double sigmaPerMetre_m = 0.20;
  double sigmaPerTurn_m = 0.60;
  double sigmaPerMetre_rad = degToRad(10);
  double sigmaPerTurn_rad = degToRad(72);
  double unknownSigma_m = 0.30;
  double unknownSigma_rad = degToRad(15);
};

void listFields(OptionTable& table, OdometryOptions& options);

/** Covariance of (x, y, phi) of a measured motion, in the axes of its start: independent errors
 * whose standard deviations are the minimum plus shares of the way and of the turn. */
Eigen::Matrix3d odometryCovariance(const Pose2& motion, const OdometryOptions& options);

/** Covariance of a motion that was not measured but taken over from the one before. */
Eigen::Matrix3d unknownMotionCovariance(const OdometryOptions& options);
}  // namespace psmks
