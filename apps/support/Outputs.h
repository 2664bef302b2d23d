/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/support/ExitCode.h>

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace psmks
{
/** Writes the outputs of a program one after the other, each beside its place (ReplacedFile). One
 * that cannot be written does not stop the others. */
class Outputs
{
 public:
  /** Writes a file.
   *  @param write called with the name of the file to write; returns whether all of it was written
   */
  void add(const std::string& path, const std::function<bool(const std::string&)>& write);

  /** Writes a text file.
   *  @param write called with the open stream */
  void addText(const std::string& path, const std::function<void(std::ostream&)>& write);

  /** Notes a file that was written elsewhere. */
  void note(const std::string& path, bool isWritten);

  bool isComplete() const { return failed_.empty(); }

  /** Which files could not be written, as a sentence without a full stop; empty where all were. */
  std::string complaint() const;

  /** @throws ProgramError (kOutputFailed) with the complaint, where there is one */
  void requireComplete() const;

 private:
  std::vector<std::string> failed_;
};
}  // namespace psmks
