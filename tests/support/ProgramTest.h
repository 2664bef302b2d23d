/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <gtest/gtest.h>
#include <tests/support/Program.h>
#include <tests/support/ScratchFolder.h>

#include <initializer_list>
#include <string>

namespace psmks::test
{
/** Tests of a program. It runs in a scratch folder, so that files can be named without one. */
class ProgramTest : public testing::Test
{
 protected:
  /** @param program path of its file */
  explicit ProgramTest(std::string program);

  /** The path of a file in the folder. */
  std::string path(const std::string& name) const { return folder_.path(name); }

  /** Runs the program.
   *  @param arguments as words of the shell
   *  @param prefix of the command, such as "NAME=VALUE" or "env -u NAME" */
  ProgramRun run(const std::string& arguments, const std::string& prefix = "") const;

  /** Expects one line on stderr that begins with the name of the program. */
  void expectOneSentence(const ProgramRun& run) const;

  /** Expects an exit code, and one line on stderr that contains all of the words. */
  void expectError(const ProgramRun& run, int exitCode,
                   std::initializer_list<std::string> words) const;

 private:
  const std::string program_;
  const ScratchFolder folder_;
};
}  // namespace psmks::test
