/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/support/ExitCode.h>
#include <apps/support/Outputs.h>

#include <fstream>
#include <string>

namespace psmks
{
/** @throws ProgramError (kUsage) naming a file that cannot be created: its path is wrong */
inline void requireCreated(bool created, const std::string& path)
{
  if (!created) throw ProgramError(kUsage, "cannot write '" + path + "'");
}

/** @throws ProgramError (kOutputFailed) naming a file that could not be written */
inline void requireWritten(bool written, const std::string& path)
{
  if (!written) throw ProgramError(kOutputFailed, "cannot write '" + path + "'");
}

/** Writes a text file beside its place, see Outputs.
 *  @param write called with the open stream
 *  @throws ProgramError (kOutputFailed) naming a file that cannot be written */
template <class Write>
void writeTextFile(const std::string& path, Write write)
{
  Outputs outputs;
  outputs.addText(path, [&write](std::ostream& out) { write(out); });
  outputs.requireComplete();
}
}  // namespace psmks
