/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <string>

namespace psmks
{
/** A text as a gnuplot string in which nothing has a meaning. Control characters become spaces. */
std::string gnuplotString(const std::string& text);

/** What a run of gnuplot left behind. */
struct GnuplotRun
{
  std::string failure;  //!< why it failed, one sentence; empty where it did not
  std::string output;   //!< the pictures that were not sent to a file
};

/** Runs gnuplot on a script, without a shell. */
GnuplotRun runGnuplot(const std::string& script);
}  // namespace psmks
