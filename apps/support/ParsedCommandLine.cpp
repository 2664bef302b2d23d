/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/support/ParsedCommandLine.h>

#include <CLI/CLI.hpp>
#include <iostream>

namespace psmks
{
std::optional<int> exitCodeOfParsing(CLI::App& program, int argc, char** argv,
                                     const std::function<void()>& check)
{
  try
  {
    program.parse(argc, argv);
    check();
    return std::nullopt;
  }
  catch (const CLI::Success& helpOrVersion)
  {
    return program.exit(helpOrVersion);
  }
  catch (const CLI::ParseError& error)
  {
    const std::string name = program.get_name();
    std::cerr << name << ": " << error.what() << " (see " << name << " --help)\n";
    return kUsage;
  }
}
}  // namespace psmks
