/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/support/ExitCode.h>

#include <filesystem>
#include <string>

namespace psmks
{
/** Checks that a file may be written.
 *  @param overwrite whether an existing file may be replaced
 *  @throws ProgramError naming a file that exists and may not be replaced */
inline void requireReplaceable(const std::string& path, bool overwrite)
{
  if (!overwrite && std::filesystem::exists(path))
    throw ProgramError(kUsage, "'" + path + "' exists, add --overwrite or name another");
}
}  // namespace psmks
