/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <string>

namespace psmks
{
/** The command that this program was started with, fit for a shell; the program without its folder.
 *  Empty where the system does not tell. */
std::string commandLine();
}  // namespace psmks
