/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/support/LogFlags.h>
#include <apps/support/ParsedCommandLine.h>

#include <optional>
#include <string>
#include <vector>

namespace psmks
{
/** What the user typed. */
struct CommandLine
{
  std::string log;
  std::string sensorFile;
  std::string config;
  std::string matcher = "psmks";
  std::optional<std::string> reference;
  LogFlags logFlags;
  std::string output;
  std::string groundTruth;
  std::string relations;
  std::string rawlog;
  std::vector<std::string> assignments;  //!< "stage.key=value"
  int maxScans = 0;                      //!< 0: all
  bool overwrite = false;
  bool view = false;
  bool printConfig = false;
  bool printOptions = false;
  bool verbose = false;

  /** Needs no log. */
  bool onlyPrints() const { return printConfig || printOptions; }
};

ParsedCommandLine<CommandLine> parseCommandLine(int argc, char** argv);
}  // namespace psmks
