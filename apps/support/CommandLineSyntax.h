/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/support/ExitCode.h>

#include <functional>
#include <optional>
#include <string>

namespace CLI
{
class App;
}

namespace psmks
{
/** What --help and --version print besides the flags. */
struct ProgramText
{
  std::string name, version;
  std::string description;  //!< above the flags
  std::string footer;       //!< below the flags
};

/** How the command line of a program is read into a struct that holds the values of its flags. */
template <class CommandLine>
struct CommandLineSyntax
{
  ProgramText text;

  /** Binds the flags to the struct. Its values before parsing are the defaults. */
  std::function<void(CLI::App&, CommandLine&)> addFlags;

  /** Called after parsing, for what concerns several flags; may throw CLI::ParseError. */
  std::function<void(CommandLine&)> check;
};

/** Parses a command line. Help and version go to stdout, an error as one sentence to stderr.
 *  @return the exit code if the program has nothing to run: after --help, --version or an error */
std::optional<int> exitCodeOfParsing(const ProgramText& text, int argc, char** argv,
                                     const std::function<void(CLI::App&)>& addFlags,
                                     const std::function<void()>& check);

/** The body of main(): parses the command line and runs the program with it.
 *  @param run takes a CommandLine and returns an ExitCode; see runToEnd()
 *  @return the program's exit code */
template <class CommandLine, class Run>
int runProgram(const CommandLineSyntax<CommandLine>& syntax, int argc, char** argv, Run run)
{
  CommandLine commandLine;
  const auto addFlags = [&](CLI::App& app) { syntax.addFlags(app, commandLine); };
  const auto check = [&] { syntax.check(commandLine); };
  if (const auto exitCode = exitCodeOfParsing(syntax.text, argc, argv, addFlags, check))
    return *exitCode;
  return runToEnd(syntax.text.name, [&] { return run(commandLine); });
}
}  // namespace psmks
