/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <string>

namespace psmks
{
/** What a program left behind. */
struct ProgramRun
{
  int exitCode = -1;   //!< -1 where it did not end by itself
  std::string output;  //!< on stdout
  std::string errors;  //!< on stderr
};

/** Runs a command of the shell, without a terminal. */
ProgramRun runProgram(const std::string& command);

/** Whether gnuplot is installed, without which programs draw no charts. */
bool hasGnuplot();

/** The whole of a file; empty where there is none. */
std::string fileText(const std::string& path);
}  // namespace psmks
