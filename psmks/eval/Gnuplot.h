/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <string>

namespace psmks
{
/** Quotes a text as a gnuplot string without any special characters. Control characters become
 * spaces. */
std::string gnuplotString(const std::string& text);

/** The result of a run of gnuplot. */
struct GnuplotRun
{
  std::string failure;  //!< one sentence that says why it failed; empty if it did not
  std::string output;   //!< the pictures that gnuplot wrote to its standard output
};

/** Runs gnuplot on a script, without a shell. */
GnuplotRun runGnuplot(const std::string& script);
}  // namespace psmks
