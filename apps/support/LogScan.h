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
/** A scan of a log, as TrajectoryBuilder takes it. */
struct LogScan
{
  Scan scan;
  Pose2 T_robot_sensor;
  std::optional<Pose2> odometry;  //!< see LaserFrame
};

/** @param options of the mounting: a scan tilted further has no valid ray, a stated turn of the
 * beam goes before that of the log */
LogScan toLogScan(const LaserFrame& frame, ScanConverter& converter,
                  const ScanMatcherOptions& options);

/** Whether any ray of the scan met anything. */
bool hasReturns(const Scan& scan);

/** The scanners that were met so far, for people: "'FRONT' (12 scans), 'REAR' (3 scans)". */
std::string quotedSensors(const LogReader& reader);
}  // namespace psmks
