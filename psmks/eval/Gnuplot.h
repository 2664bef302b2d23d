/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/Chart.h>

#include <string>

namespace psmks
{
/** A text as a gnuplot string in which nothing has a meaning. Control characters become spaces. */
std::string gnuplotString(const std::string& text);

/** The commands that draw a chart on a terminal that is set up. */
std::string gnuplotCommands(const Chart& chart);

/** Runs gnuplot on a script, without a shell.
 *  @return why it failed, one sentence; empty where it did not */
std::string runGnuplot(const std::string& script);
}  // namespace psmks
