/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-convert/CommandLine.h>
#include <psmks/logs/LogReader.h>

#include <memory>
#include <string>

namespace psmks
{
/** The destination of the scans of a log. */
class LogSink
{
 public:
  virtual ~LogSink() = default;

  /** Appends a frame.
   *  @throws ProgramError if the file cannot be written */
  virtual void write(const LaserFrame& frame) = 0;

  /** Has to be called after the last frame.
   *  @return a description of the file for a sentence, such as "1051 scans"
   *  @throws ProgramError if the file cannot be written */
  virtual std::string finish() = 0;
};

/** Creates the output file of a command line.
 *  @throws ProgramError if it cannot be created or a ground truth cannot be read */
std::unique_ptr<LogSink> makeLogSink(const CommandLine& commandLine);
}  // namespace psmks
