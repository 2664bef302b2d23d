/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/support/CommandLineSyntax.h>
#include <apps/support/LogFlags.h>

#include <string>

namespace psmks
{
/** The kind of a file to write, which the ending of its name says. */
enum class OutputKind
{
  Rawlog,    //!< .rawlog
  Carmen,    //!< .log, .clf
  Pairs,     //!< .pairs
  Segments,  //!< .csv
  Sensor,    //!< .ini
  Unknown
};

/** The values of the flags of psmks-convert. */
struct CommandLine
{
  std::string input, output;
  LogFlags logFlags;
  std::string groundTruth;
  int every = 1;
  int maxScans = 0;  //!< 0: all
  bool observations = false;
  bool overwrite = false;
  bool sensorReport = false;

  OutputKind outputKind() const;
};

/** The flags of psmks-convert. */
CommandLineSyntax<CommandLine> commandLineSyntax();
}  // namespace psmks
