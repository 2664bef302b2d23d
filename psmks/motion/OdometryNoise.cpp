/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/motion/OdometryNoise.h>

namespace psmks
{
void listFields(OptionTable& table, OdometryOptions& o)
{
  table.beginSection("odometry", "How far the odometry between two scans is trusted.");
  table.add("min_sigma_m", o.minSigma_m, Unit::Metre, 1e-4, 10,
            "standard deviation of a position after no motion at all");
  table.add("min_sigma_deg", o.minSigma_rad, Unit::Degree, degToRad(1e-3), degToRad(180),
            "the same for the heading");
  table.add("sigma_per_metre_m", o.sigmaPerMetre_m, Unit::Metre, 0, 10,
            "position: added for every metre driven");
  table.add("sigma_per_turn_m", o.sigmaPerTurn_m, Unit::Metre, 0, 10,
            "position: added for every 360 degrees turned");
  table.add("sigma_per_metre_deg", o.sigmaPerMetre_rad, Unit::Degree, 0, degToRad(180),
            "heading: added for every metre driven");
  table.add("sigma_per_turn_deg", o.sigmaPerTurn_rad, Unit::Degree, 0, degToRad(360),
            "heading: added for every 360 degrees turned");
  table.add("unknown_sigma_m", o.unknownSigma_m, Unit::Metre, 1e-3, 100,
            "position, where a scan comes without odometry and nothing tells the speed");
  table.add("unknown_sigma_deg", o.unknownSigma_rad, Unit::Degree, degToRad(1e-2), degToRad(180),
            "the same for the heading");
  table.add("acceleration_sigma_m_s2", o.accelerationSigma_m_s2, Unit::None, 0, 1000,
            "without odometry the last motion goes on; its standard deviation is min_sigma_m and "
            "this times the square of its duration, at most unknown_sigma_m");
  table.add("acceleration_sigma_deg_s2", o.accelerationSigma_rad_s2, Unit::Degree, 0, degToRad(1e5),
            "the same for the heading");
}

Eigen::Matrix3d diagonalCovariance(double sigma_m, double sigma_rad)
{
  return Eigen::Vector3d(sigma_m * sigma_m, sigma_m * sigma_m, sigma_rad * sigma_rad).asDiagonal();
}

Eigen::Matrix3d odometryCovariance(const Pose2& motion, const OdometryOptions& o)
{
  const double way_m = motion.translation().norm();
  const double turns = std::abs(motion.phi_rad) / (2 * kPi);
  return diagonalCovariance(
      o.minSigma_m + o.sigmaPerMetre_m * way_m + o.sigmaPerTurn_m * turns,
      o.minSigma_rad + o.sigmaPerMetre_rad * way_m + o.sigmaPerTurn_rad * turns);
}

Eigen::Matrix3d unknownMotionCovariance(const OdometryOptions& o)
{
  return diagonalCovariance(o.unknownSigma_m, o.unknownSigma_rad);
}
}  // namespace psmks
