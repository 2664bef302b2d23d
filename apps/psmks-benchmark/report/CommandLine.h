/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <string>

namespace psmks
{
/** The command that started this program, quoted for a shell, with the program without its folder.
 * It is empty if the system does not provide it. */
std::string commandLine();
}  // namespace psmks
