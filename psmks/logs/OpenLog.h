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
  /** The sensor to read; by default that of the first scan. */
  std::optional<std::string> sensorLabel;
  CarmenOptions carmen;
};

/** Opens a log of any kind. A text is read as a CARMEN log, anything else as an MRPT rawlog,
 * whatever the name of the file. For a file that cannot be read, the damage() of the reader says
 * so. */
std::unique_ptr<LogReader> openLog(const std::string& path,
                                   const LogOptions& options = LogOptions());

/** Whether a file, gzipped or not, begins with text. */
bool isText(const std::string& path);
}  // namespace psmks
