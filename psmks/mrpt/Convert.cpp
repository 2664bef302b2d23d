/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <mrpt/core/Clock.h>
#include <mrpt/system/datetime.h>
#include <psmks/mrpt/Convert.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
using mrpt::obs::CObservation2DRangeScan;
using mrpt::poses::CPose2D;
using mrpt::poses::CPosePDFGaussian;

namespace
{
/** How many rays of an observation point to distinct bearings. */
int distinctRays(int rays, double increment_rad)
{
  return static_cast<int>(std::min<double>(rays, std::round(2 * kPi / increment_rad)));
}

/** The standard deviation of a range where the observation states a sensible one, else 0. */
double rangeSigma_m(const CObservation2DRangeScan& observation)
{
  static const float kUnstated_m = CObservation2DRangeScan().stdError;
  constexpr float kSmallest_m = 1e-4f, kLargest_m = 1.0f;
  const float sigma_m = observation.stdError;
  const bool stated = sigma_m != kUnstated_m && sigma_m >= kSmallest_m && sigma_m <= kLargest_m;
  return stated ? sigma_m : 0.0;
}

/** Seconds since the epoch, 0 where the observation has no time stamp. */
double stamp_s(const CObservation2DRangeScan& observation)
{
  return observation.timestamp == INVALID_TIMESTAMP ? 0.0
                                                    : mrpt::Clock::toDouble(observation.timestamp);
}
}  // namespace

Pose2 toPose2(const CPose2D& pose) { return {pose.x(), pose.y(), wrapAngle(pose.phi())}; }

CPose2D toMrpt(const Pose2& pose) { return {pose.x_m, pose.y_m, pose.phi_rad}; }

UncertainPose toUncertainPose(const CPosePDFGaussian& pdf)
{
  return {toPose2(pdf.mean), pdf.cov.asEigen()};
}

CPosePDFGaussian toMrpt(const UncertainPose& pose)
{
  CPosePDFGaussian pdf(toMrpt(pose.pose));
  pdf.cov.asEigen() = pose.covariance;
  return pdf;
}

SensorMounting sensorMounting(const CObservation2DRangeScan& observation)
{
  const auto R = observation.sensorPose.getRotationMatrix();
  const double uprightness = R(2, 2);  // cosine between the sensor's z axis and the vertical
  SensorMounting mounting;
  mounting.T_robot_sensor = {observation.sensorPose.x(), observation.sensorPose.y(),
                             std::atan2(R(1, 0), R(0, 0))};
  mounting.upsideDown = uprightness < 0;
  mounting.tilt_rad =
      std::max(std::acos(std::min(1.0, std::abs(uprightness))), std::abs(observation.deltaPitch));
  return mounting;
}

const BeamGrid& ScanConverter::gridOf(const CObservation2DRangeScan& observation)
{
  const int rays = static_cast<int>(observation.getScanSize());
  const double aperture_rad = observation.aperture;
  if (rays < 2 || !(aperture_rad > 0) || !std::isfinite(aperture_rad)) return grid_ = BeamGrid();

  const double increment_rad = aperture_rad / (rays - 1);
  const double first_rad = -aperture_rad / 2;
  const int count = distinctRays(rays, increment_rad);
  if (!BeamGrid::accepts(first_rad, increment_rad, count)) return grid_ = BeamGrid();
  const bool known = grid_.count() == count && grid_.firstBearing_rad() == first_rad &&
                     grid_.increment_rad() == increment_rad;
  if (!known) grid_ = BeamGrid(first_rad, increment_rad, count);
  return grid_;
}

void ScanConverter::convert(const CObservation2DRangeScan& observation, Scan& scan)
{
  scan.grid = gridOf(observation);
  const std::size_t rays = observation.getScanSize();
  const std::size_t count = static_cast<std::size_t>(scan.grid.count());
  scan.range_m.resize(count);
  scan.valid.assign(count, 0);

  const bool counterClockwise = observation.rightToLeft != sensorMounting(observation).upsideDown;
  for (std::size_t k = 0; count > 0 && k < rays; ++k)
  {
    const std::size_t ray = counterClockwise ? k : rays - 1 - k;
    const std::size_t i = k % count;  // rays beyond once round fall on those already taken
    if (scan.valid[i]) continue;
    scan.range_m[i] = observation.getScanRange(ray);
    scan.valid[i] = observation.getScanRangeValidity(ray);
  }
  scan.maxRange_m = observation.maxRange > 0 ? observation.maxRange : 0.0;
  scan.rangeSigma_m = rangeSigma_m(observation);
  scan.stamp_s = stamp_s(observation);
  scan.sweepDuration_s = 0;
}

Scan ScanConverter::convert(const CObservation2DRangeScan& observation)
{
  Scan scan;
  convert(observation, scan);
  return scan;
}
}  // namespace psmks
