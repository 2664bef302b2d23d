/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <gtest/gtest.h>
#include <tests/support/Program.h>
#include <tests/support/ScratchFolder.h>

#include <initializer_list>
#include <string>

namespace psmks::test
{
/** Tests of a program that runs in a folder of its own, so that files may be named without one. */
class ProgramTest : public testing::Test
{
 protected:
  /** @param program the path of its file */
  explicit ProgramTest(std::string program);

  /** Of a file in the folder. */
  std::string path(const std::string& name) const { return folder_.path(name); }

  /** @param arguments as words of the shell
   *  @param prefix of the command: "NAME=VALUE", "env -u NAME" */
  ProgramRun run(const std::string& arguments, const std::string& prefix = "") const;

  /** On stderr is one line, the program's own word first. */
  void expectOneSentence(const ProgramRun& run) const;

  /** It ended so, with one sentence that holds every one of the words. */
  void expectError(const ProgramRun& run, int exitCode,
                   std::initializer_list<std::string> words) const;

 private:
  const std::string program_;
  const ScratchFolder folder_;
};
}  // namespace psmks::test
