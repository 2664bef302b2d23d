/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/base/OptionTable.h>
#include <psmks/geometry/Angle.h>
#include <psmks/geometry/Pose2.h>

#include <Eigen/Core>

namespace psmks
{
/** Standard deviations of a motion that the wheels of a robot measured, and of one that nothing
 * measured. A turn is 360 degrees. */
struct OdometryOptions
{
  double minSigma_m = 0.02;                 //!< after no motion at all
  double minSigma_rad = degToRad(1);        //!< after no motion at all
  double sigmaPerMetre_m = 0.20;            //!< of the position, added for each metre driven
  double sigmaPerTurn_m = 0.60;             //!< of the position, added for each turn
  double sigmaPerMetre_rad = degToRad(10);  //!< of the heading, added for each metre driven
  double sigmaPerTurn_rad = degToRad(72);   //!< of the heading, added for each turn
  double unknownSigma_m = 0.30;             //!< of a motion that was not measured
  double unknownSigma_rad = degToRad(15);   //!< of a motion that was not measured
  double accelerationSigma_m_s2 = 2.0;      //!< of a robot that goes on at the same speed
  double accelerationSigma_rad_s2 = degToRad(250);  //!< of a robot that turns at the same rate
};

/** Adds the section `[odometry]` with every field of the options. */
void listFields(OptionTable& table, OdometryOptions& options);

/** Covariance of (x, y, phi) of independent errors, in m^2 and rad^2. */
Eigen::Matrix3d diagonalCovariance(double sigma_m, double sigma_rad);

/** Covariance of (x, y, phi) of a motion that was measured, in the axes of its start, in m^2 and
 * rad^2. The three errors are independent. The standard deviation of each is the least one, plus
 * what the distance between start and end adds, plus what the angle between them adds. */
Eigen::Matrix3d odometryCovariance(const Pose2& motion, const OdometryOptions& options);

/** Covariance of (x, y, phi) of a motion of which nothing is known. */
Eigen::Matrix3d unknownMotionCovariance(const OdometryOptions& options);
}  // namespace psmks
