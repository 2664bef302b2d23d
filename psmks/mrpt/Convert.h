/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/poses/CPose2D.h>
#include <mrpt/poses/CPosePDFGaussian.h>
#include <psmks/geometry/Pose2.h>
#include <psmks/geometry/Scan.h>
#include <psmks/geometry/UncertainPose.h>

/** \file
 * Conversion between MRPT's types and those of psmks. This is the one place where the scanning
 * direction, the mounting of a scanner and its offset from the robot are taken into account. */

namespace psmks
{
/** The same pose, with the angle wrapped to (-pi, pi]. */
Pose2 toPose2(const mrpt::poses::CPose2D& pose);
mrpt::poses::CPose2D toMrpt(const Pose2& pose);

/** The same pose with the same covariance of (x, y, phi): m^2, m rad, rad^2. */
UncertainPose toUncertainPose(const mrpt::poses::CPosePDFGaussian& pdf);
mrpt::poses::CPosePDFGaussian toMrpt(const UncertainPose& pose);

/** How a scanner sits on a robot, as far as it matters in the plane. */
struct SensorMounting
{
  /** Position of the scanner and direction of its x axis, both projected to the ground. */
  Pose2 T_robot_sensor;

  /** The scanner's z axis points down, so that rays that it takes counter-clockwise turn clockwise
   *  when seen from above. */
  bool upsideDown = false;

  /** Largest angle between the scan plane and the ground during the sweep, 0 to pi/2. */
  double tilt_rad = 0;
};

/** The mounting that an observation states by `sensorPose` and `deltaPitch`. */
SensorMounting sensorMounting(const mrpt::obs::CObservation2DRangeScan& observation);

/** Turns observations into scans in the planar sensor frame that SensorMounting describes.
 *
 * A converter keeps the beam grid of the last observation. With one converter for each scanner, all
 * scans of a scanner share one table of directions. One converter serves one thread. */
class ScanConverter
{
 public:
  /** Converts one observation. Bad data does not throw: an observation with fewer than two rays, or
   *  with an aperture that is not above 0, gives a scan without rays.
   *
   *  - The rays of the scan go counter-clockwise seen from above, whatever `rightToLeft` and the
   *    mounting are.
   *  - Rays that go more than once round are dropped: with an aperture of 2 pi, MRPT's first and
   *    last ray coincide. A dropped ray replaces an invalid one that it coincides with.
   *  - `validRange` is kept as a flag; ranges are copied as they are, NaN included.
   *  - `stdError` becomes the standard deviation of a range, unless it still has MRPT's default or
   *    lies outside 0.1 mm to 1 m. Then the deviation is unknown, and psmks' own options apply.
   *  - A time stamp that is not set becomes 0 s; the duration of the sweep is unknown.
   *
   *  @param[out] scan is replaced; nothing is allocated if it held as many rays before */
  void convert(const mrpt::obs::CObservation2DRangeScan& observation, Scan& scan);

  Scan convert(const mrpt::obs::CObservation2DRangeScan& observation);

 private:
  const BeamGrid& gridOf(const mrpt::obs::CObservation2DRangeScan& observation);

  BeamGrid grid_;
};
}  // namespace psmks
