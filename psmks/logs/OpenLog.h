/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/logs/CarmenOptions.h>
#include <psmks/logs/LogReader.h>
#include <psmks/logs/RosBagReader.h>

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
  RosBagOptions rosBag;
};

/** Opens a log of any kind. Its first scans are looked at before (LogSurvey): of several sensors
 * the one with most scans is read, and readings that are phantom rings are made invalid
 * (QuietReader). The kind of a file is recognised by its content, whatever its name (LogKind). For
 * a file that cannot be read, the damage() of the reader says so, and what it seems to be. */
std::unique_ptr<LogReader> openLog(const std::string& path,
                                   const LogOptions& options = LogOptions());
}  // namespace psmks
