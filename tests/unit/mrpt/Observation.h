/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/poses/CPoint3D.h>
#include <tests/support/Scenes.h>

#include <cmath>
#include <vector>

namespace psmks::test
{
/** A laser scanner of 2 rays a degree. */
struct Scanner
{
  mrpt::poses::CPose3D sensorPose = {};
  bool rightToLeft = true;
  double aperture_rad = kPi;
  int rays = 361;
  double maxRange_m = 80;
};

/** What a robot at T_world_robot sees of the walls. Each ray is cast in the direction that MRPT
 * gives it in space, by its own angle and the 3D pose of the sensor. */
inline mrpt::obs::CObservation2DRangeScan observe(const std::vector<Wall>& walls,
                                                  const mrpt::poses::CPose2D& T_world_robot,
                                                  const Scanner& scanner = {})
{
  mrpt::obs::CObservation2DRangeScan observation;
  observation.aperture = static_cast<float>(scanner.aperture_rad);
  observation.rightToLeft = scanner.rightToLeft;
  observation.maxRange = static_cast<float>(scanner.maxRange_m);
  observation.sensorPose = scanner.sensorPose;
  observation.resizeScanAndAssign(static_cast<std::size_t>(scanner.rays), 0, true);

  const mrpt::poses::CPose3D T_world_sensor =
      mrpt::poses::CPose3D(T_world_robot) + scanner.sensorPose;
  for (std::size_t i = 0; i < observation.getScanSize(); ++i)
  {
    const double angle_rad = observation.getScanAngle(i);
    const auto tip =
        T_world_sensor + mrpt::poses::CPoint3D(std::cos(angle_rad), std::sin(angle_rad), 0);
    const double bearing_rad =
        std::atan2(tip.y() - T_world_sensor.y(), tip.x() - T_world_sensor.x());
    const Scan ray = castScan(walls, {T_world_sensor.x(), T_world_sensor.y(), 0},
                              BeamGrid(bearing_rad, 1, 1), observation.maxRange);
    observation.setScanRange(i, static_cast<float>(ray.range_m[0]));
    observation.setScanRangeValidity(i, ray.range_m[0] < observation.maxRange);
  }
  return observation;
}
}  // namespace psmks::test
