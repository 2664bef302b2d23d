/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/psm/PsmCorridor.h>
#include <psmks/psm/PsmCovariance.h>

#include <Eigen/Geometry>
#include <algorithm>

namespace psmks
{
Eigen::Matrix3d psmCovariance(const PsmScan& reference, double errorIndex_m,
                              const PsmOptions& options)
{
  const std::optional<double> corridor_rad = corridorDirection_rad(reference, options);
  const Eigen::Matrix2d axes = Eigen::Rotation2Dd(corridor_rad.value_or(0)).toRotationMatrix();
  Eigen::Vector2d sigma_m = Eigen::Vector2d::Constant(options.roomPositionSigma_m);
  if (corridor_rad) sigma_m = {options.alongCorridorSigma_m, options.acrossCorridorSigma_m};

  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  covariance.topLeftCorner<2, 2>() = axes * sigma_m.cwiseAbs2().asDiagonal() * axes.transpose();
  covariance(2, 2) = options.headingSigma_rad * options.headingSigma_rad;
  return covariance * std::max(1.0, (errorIndex_m - options.errorOffset_m) / options.errorStep_m);
}
}  // namespace psmks
