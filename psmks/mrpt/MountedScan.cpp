/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/motion/Sweep.h>
#include <psmks/mrpt/MountedScan.h>

namespace psmks
{
MountedScan toMountedScan(const mrpt::obs::CObservation2DRangeScan& observation,
                          ScanConverter& converter, const ScanMatcherOptions& options,
                          double knownBeamTurn_s)
{
  const SensorMounting mounting = sensorMounting(observation);
  MountedScan mounted{converter.convert(observation), mounting.T_robot_sensor};
  Scan& scan = mounted.scan;
  const double beamTurn_s = options.beamTurn_s != 0 ? options.beamTurn_s : knownBeamTurn_s;
  const bool raysReversed = observation.rightToLeft == mounting.upsideDown;
  scan.sweepDuration_s = sweepDuration_s(scan.grid, raysReversed ? -beamTurn_s : beamTurn_s);
  if (mounting.tilt_rad > options.maxTilt_rad) scan.valid.assign(scan.valid.size(), 0);
  return mounted;
}
}  // namespace psmks
