/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Scan.h>
#include <psmks/logs/LogReader.h>
#include <psmks/mrpt/Convert.h>
#include <psmks/mrpt/ScanMatcherOptions.h>

#include <optional>
#include <string>

namespace psmks
{
/** A scan of a log in the form that TrajectoryBuilder takes. */
struct LogScan
{
  Scan scan;
  Pose2 T_robot_sensor;
  std::optional<Pose2> odometry;  //!< see LaserFrame
};

/** Converts a scan of a log.
 *  @param options of the mounting: the rays of a scan with a larger tilt become invalid, and a
 *      stated time of a turn of the beam has priority over that of the log */
LogScan toLogScan(const LaserFrame& frame, ScanConverter& converter,
                  const ScanMatcherOptions& options);

/** The scanners of the log so far, for people: "'FRONT' (12 scans), 'REAR' (3 scans)". */
std::string quotedSensors(const LogReader& reader);
}  // namespace psmks
