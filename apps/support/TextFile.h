/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/support/ExitCode.h>

#include <fstream>
#include <string>

namespace psmks
{
/** @throws ProgramError naming a file that could not be written */
inline void requireWritten(bool written, const std::string& path)
{
  if (!written) throw ProgramError(kUsage, "cannot write '" + path + "'");
}

/** Writes a text file.
 *  @param write called with the open stream
 *  @throws ProgramError naming a file that cannot be written */
template <class Write>
void writeTextFile(const std::string& path, Write write)
{
  std::ofstream file(path);
  write(file);
  file.close();
  requireWritten(!file.fail(), path);
}
}  // namespace psmks
