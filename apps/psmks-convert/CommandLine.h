/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/support/LogFlags.h>
#include <apps/support/ParsedCommandLine.h>

#include <string>

namespace psmks
{
/** What a file is converted to: the ending of its name says it. */
enum class OutputKind
{
  Rawlog,    //!< .rawlog
  Carmen,    //!< .log, .clf
  Pairs,     //!< .pairs
  Segments,  //!< .csv
  Unknown
};

/** What the user typed. */
struct CommandLine
{
  std::string input, output;
  LogFlags logFlags;
  std::string groundTruth;
  int every = 1;
  int maxScans = 0;  //!< 0: all
  bool observations = false;
  bool overwrite = false;

  OutputKind outputKind() const;
};

ParsedCommandLine<CommandLine> parseCommandLine(int argc, char** argv);
}  // namespace psmks
