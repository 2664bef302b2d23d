/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/mrpt/MountedScan.h>

namespace psmks
{
MountedScan toMountedScan(const mrpt::obs::CObservation2DRangeScan& observation,
                          ScanConverter& converter, const ScanMatcherOptions& options,
                          const BeamTiming& known)
{
  const SensorMounting mounting = sensorMounting(observation);
  MountedScan mounted{converter.convert(observation), mounting.T_robot_sensor};
  Scan& scan = mounted.scan;
  BeamTiming timing = options.beam.turn_s != 0 ? options.beam : known;
  const bool raysReversed = observation.rightToLeft == mounting.upsideDown;
  if (raysReversed) timing.turn_s = -timing.turn_s;
  setTiming(timing, scan);
  if (mounting.tilt_rad > options.maxTilt_rad) scan.valid.assign(scan.valid.size(), 0);
  return mounted;
}
}  // namespace psmks
