/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-convert/CommandLine.h>
#include <psmks/logs/LogReader.h>

#include <memory>
#include <string>

namespace psmks
{
/** Where the scans of a log go. */
class LogSink
{
 public:
  virtual ~LogSink() = default;

  /** @throws std::exception where the file cannot be written */
  virtual void write(const LaserFrame& frame) = 0;

  /** After the last frame.
   *  @return what there is to say of the file, half a sentence: "1051 scans"
   *  @throws std::exception where the file cannot be written */
  virtual std::string finish() = 0;
};

/** The file of a command line, created now.
 *  @throws ProgramError where it cannot be created, or a ground truth cannot be read */
std::unique_ptr<LogSink> makeLogSink(const CommandLine& commandLine);
}  // namespace psmks
