/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/logs/CarmenOptions.h>
#include <psmks/logs/LogReader.h>

#include <memory>
#include <optional>
#include <string>

namespace psmks
{
struct LogOptions
{
  /** The sensor to read; by default the one with most scans. */
  std::optional<std::string> sensorLabel;
  CarmenOptions carmen;
};

/** Opens a log of any kind. Its first scans are looked at before (LogSurvey): of several sensors
 * the one with most scans is read, and readings that are phantom rings are made invalid
 * (QuietReader). A text is read as a CARMEN log, anything else as an MRPT rawlog, whatever the name
 * of the file. For a file that cannot be read, the damage() of the reader says so. */
std::unique_ptr<LogReader> openLog(const std::string& path,
                                   const LogOptions& options = LogOptions());

/** Whether a file, gzipped or not, begins with text. */
bool isText(const std::string& path);
}  // namespace psmks
