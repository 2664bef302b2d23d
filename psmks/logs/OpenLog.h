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
  std::optional<std::string> sensorLabel;  //!< the sensor to read; none: that of the first scan
  CarmenOptions carmen;
};

/** A reader for a log of any kind: text is a CARMEN log, all else an MRPT rawlog, whatever the
 * file's name. A file that cannot be read gives a reader that says so. */
std::unique_ptr<LogReader> openLog(const std::string& path,
                                   const LogOptions& options = LogOptions());

/** Whether a file, gzipped or not, begins with text. */
bool isText(const std::string& path);
}  // namespace psmks
