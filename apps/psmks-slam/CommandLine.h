/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/support/CommandLineSyntax.h>
#include <apps/support/LogFlags.h>

#include <optional>
#include <string>
#include <vector>

namespace psmks
{
/** The values of the flags of psmks-slam. */
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
  std::string graph;                     //!< file for the graph in the format of g2o
  std::vector<std::string> outputs;      //!< of outputNames()
  std::vector<std::string> assignments;  //!< "stage.key=value"
  int maxScans = 0;                      //!< 0: all
  bool overwrite = false;
  bool noPicture = false;
  bool view = false;
  bool printConfig = false;
  bool printOptions = false;
  bool verbose = false;

  /** Whether options are printed only, which needs no log. */
  bool onlyPrints() const { return printConfig || printOptions; }
};

/** The flags of psmks-slam. */
CommandLineSyntax<CommandLine> commandLineSyntax();
}  // namespace psmks
