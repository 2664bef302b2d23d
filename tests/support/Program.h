/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <string>

namespace psmks
{
/** The result of a run of a program. */
struct ProgramRun
{
  int exitCode = -1;   //!< -1 if a signal ended it
  std::string output;  //!< text on stdout
  std::string errors;  //!< text on stderr
};

/** Runs a command of the shell without a terminal. */
ProgramRun runProgram(const std::string& command);

/** Whether gnuplot is installed, which programs need to draw charts. */
bool hasGnuplot();

/** The content of a file; empty if there is no such file. */
std::string fileText(const std::string& path);
}  // namespace psmks
