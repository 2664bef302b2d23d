/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <string>

namespace psmks
{
/** By what reader a file is read. */
enum class LogReading
{
  Rawlog,  //!< also what is of no known kind
  Carmen,  //!< any text
  RosBag,
  None  //!< something known that psmks does not read
};

/** What the content of a file tells of its kind. */
struct LogKind
{
  LogReading reading = LogReading::Rawlog;

  /** What it seems to be instead of a log of its reading, such as "a table (CSV)"; empty where
   * nothing speaks against it. */
  std::string seems;

  /** What to do with such a file, as a sentence without a full stop; empty where nothing is known.
   */
  std::string advice;
};

/** Recognises a file by its first bytes, gzipped or not, whatever its name. A file that cannot be
 * opened counts as a rawlog, whose reader says so. */
LogKind recogniseLog(const std::string& path);
}  // namespace psmks
