/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/poses/CPose2D.h>
#include <mrpt/poses/CPosePDFGaussian.h>
#include <psmks/geometry/Pose2.h>
#include <psmks/geometry/Scan.h>
#include <psmks/geometry/UncertainPose.h>

/** \file
 * The border between MRPT's types and psmks': the one place where scanning direction, mounting and
 * the sensor's offset from the robot are settled. */

namespace psmks
{
Pose2 toPose2(const mrpt::poses::CPose2D& pose);
mrpt::poses::CPose2D toMrpt(const Pose2& pose);

UncertainPose toUncertainPose(const mrpt::poses::CPosePDFGaussian& pdf);
mrpt::poses::CPosePDFGaussian toMrpt(const UncertainPose& pose);

/** How a scanner sits on a robot, as far as the plane sees it. */
struct SensorMounting
{
  /** Position of the scanner and direction of its x axis, both projected to the ground. */
  Pose2 T_robot_sensor;

  /** The scanner's z axis points down: its counter-clockwise is clockwise from above. */
  bool upsideDown = false;

  /** Largest angle between the scan plane and the ground during the sweep. */
  double tilt_rad = 0;
};

SensorMounting sensorMounting(const mrpt::obs::CObservation2DRangeScan& observation);

/** Turns observations into scans in the planar sensor frame of SensorMounting.
 *
 * Keeps the beam grid of the last observation: use one converter per scanner, and its scans share
 * their directions. */
class ScanConverter
{
 public:
  /** Bad data does not throw: fewer than two rays, or an aperture that is not above 0, give a scan
   *  without rays.
   *
   *  - Rays come out counter-clockwise seen from above, whatever `rightToLeft` and the mounting.
   *  - Rays that go more than once round (aperture 2 pi: MRPT's first and last ray coincide) are
   *    dropped; a dropped ray stands in for an invalid one that it coincides with.
   *  - `validRange` is kept as a flag; ranges are copied as they are, NaN included.
   *  - `stdError` becomes the range sigma, unless it still has MRPT's default or is no sensible
   *    value (0.1 mm to 1 m): then the sigma is unknown, and psmks' own options apply.
   *
   *  @param[out] scan replaced; allocates nothing if it held as many rays before */
  void convert(const mrpt::obs::CObservation2DRangeScan& observation, Scan& scan);

  Scan convert(const mrpt::obs::CObservation2DRangeScan& observation);

 private:
  const BeamGrid& gridOf(const mrpt::obs::CObservation2DRangeScan& observation);

  BeamGrid grid_;
};
}  // namespace psmks
