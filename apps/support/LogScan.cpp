/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/support/LogScan.h>
#include <psmks/base/ShortText.h>
#include <psmks/mrpt/MountedScan.h>

#include <utility>

namespace psmks
{
LogScan toLogScan(const LaserFrame& frame, ScanConverter& converter,
                  const ScanMatcherOptions& options)
{
  MountedScan mounted = toMountedScan(*frame.scan, converter, options, frame.beam);
  mounted.scan.stamp_s = frame.stamp_s;
  return {std::move(mounted.scan), mounted.T_robot_sensor, frame.odometry};
}

std::string quotedSensors(const LogReader& reader)
{
  std::string text;
  for (const auto& [label, scans] : reader.scansOfSensors())
    text +=
        (text.empty() ? "'" : ", '") + shortText(label) + "' (" + std::to_string(scans) + " scans)";
  return text;
}
}  // namespace psmks
