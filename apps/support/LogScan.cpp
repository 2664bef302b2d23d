/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/support/LogScan.h>
#include <psmks/motion/Sweep.h>
#include <psmks/segmentation/Preprocessing.h>

#include <algorithm>

namespace psmks
{
LogScan toLogScan(const LaserFrame& frame, ScanConverter& converter,
                  const ScanMatcherOptions& options)
{
  const SensorMounting mounting = sensorMounting(*frame.scan);
  LogScan result{converter.convert(*frame.scan), mounting.T_robot_sensor, frame.odometry};
  result.scan.stamp_s = frame.stamp_s;
  const double beamTurn_s = options.beamTurn_s != 0 ? options.beamTurn_s : frame.beamTurn_s;
  const bool raysReversed = frame.scan->rightToLeft == mounting.upsideDown;
  result.scan.sweepDuration_s =
      sweepDuration_s(result.scan.grid, raysReversed ? -beamTurn_s : beamTurn_s);
  if (mounting.tilt_rad > options.maxTilt_rad)
    std::fill(result.scan.valid.begin(), result.scan.valid.end(), std::uint8_t{0});
  return result;
}

bool hasReturns(const Scan& scan)
{
  SegmentedScan cleaned;
  cleanScan(scan, PreprocessingOptions(), cleaned);
  return cleaned.hasValidRay();
}

std::string quotedSensors(const LogReader& reader)
{
  std::string text;
  for (const auto& [label, scans] : reader.scansOfSensors())
    text += (text.empty() ? "'" : ", '") + label + "' (" + std::to_string(scans) + " scans)";
  return text;
}
}  // namespace psmks
