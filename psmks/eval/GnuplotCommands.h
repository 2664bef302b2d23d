/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/Chart.h>
#include <psmks/eval/HeatMap.h>

#include <string>

namespace psmks
{
/** The commands that draw a panel on the present terminal, whatever was drawn before. */
std::string gnuplotCommands(const Chart& chart);
std::string gnuplotCommands(const HeatMap& map);
}  // namespace psmks
