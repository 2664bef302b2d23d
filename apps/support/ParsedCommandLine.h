/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/support/ExitCode.h>

#include <functional>
#include <optional>
#include <utility>

namespace CLI
{
class App;
}

namespace psmks
{
/** What the user typed, or the exit code where there is nothing to run: --help, --version, or an
 * error that was told already. */
template <class CommandLine>
struct ParsedCommandLine
{
  std::optional<CommandLine> commandLine;
  int exitCode = kOk;
};

/** Parses into what the flags of the program are bound to. Help goes to stdout, an error as one
 * sentence to stderr.
 *  @param check looks at what was parsed; may throw CLI::ParseError
 *  @return the exit code where there is nothing to run */
std::optional<int> exitCodeOfParsing(CLI::App& program, int argc, char** argv,
                                     const std::function<void()>& check);

/** As exitCodeOfParsing().
 *  @param commandLine that the flags are bound to
 *  @param check called with the command line */
template <class CommandLine, class Check>
ParsedCommandLine<CommandLine> parsed(CLI::App& program, int argc, char** argv,
                                      CommandLine& commandLine, Check check)
{
  if (const auto exitCode = exitCodeOfParsing(program, argc, argv, [&] { check(commandLine); }))
    return {std::nullopt, *exitCode};
  return {std::move(commandLine), kOk};
}
}  // namespace psmks
