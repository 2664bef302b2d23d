/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/support/LogScan.h>
#include <psmks/core/Preprocessing.h>

#include <algorithm>

namespace psmks
{
LogScan toLogScan(const LaserFrame& frame, ScanConverter& converter, double maxTilt_rad)
{
  const SensorMounting mounting = sensorMounting(*frame.scan);
  LogScan result{converter.convert(*frame.scan), mounting.T_robot_sensor, frame.odometry};
  result.scan.stamp_s = frame.stamp_s;
  if (mounting.tilt_rad > maxTilt_rad)
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
