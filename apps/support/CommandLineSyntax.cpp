/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/support/CommandLineSyntax.h>

#include <CLI/CLI.hpp>
#include <iostream>

namespace psmks
{
std::optional<int> exitCodeOfParsing(const ProgramText& text, int argc, char** argv,
                                     const std::function<void(CLI::App&)>& addFlags,
                                     const std::function<void()>& check)
{
  CLI::App program(text.description, text.name);
  program.footer(text.footer);
  addFlags(program);
  program.set_version_flag("--version", text.name + ' ' + text.version);
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
    std::cerr << text.name << ": " << error.what() << " (see " << text.name << " --help)\n";
    return kUsage;
  }
}
}  // namespace psmks
