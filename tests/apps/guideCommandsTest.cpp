/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <tests/support/Program.h>
#include <tests/support/Says.h>
#include <tests/support/ScratchFolder.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <vector>

namespace psmks
{
namespace
{
const std::string kSource = PSMKS_SOURCE_DIR;
const std::string kPrograms = PSMKS_PROGRAMS;    // folder of the built programs
const std::string kLibraries = PSMKS_LIBRARIES;  // and of the libraries, one a plugin of MRPT

/** Pages whose blocks of shell commands, those that begin with ```sh, are run. */
const std::vector<std::string> kPages = {"README.md",
                                         "docs/programs.md",
                                         "docs/cicp.md",
                                         "docs/when-it-fails.md",
                                         "docs/simulation.md",
                                         "docs/how-it-works.md",
                                         "config/README.md",
                                         "rawlogs/README.md",
                                         "docs/map-and-loops.md"};

/** The lines of all blocks of shell commands of a page; a line that ends in a backslash goes on. */
std::vector<std::string> commandsOf(const std::string& page)
{
  std::istringstream text(fileText(kSource + "/" + page));
  std::vector<std::string> commands;
  bool inside = false, continued = false;
  for (std::string line; std::getline(text, line);)
  {
    if (line.rfind("```", 0) == 0)
      inside = !inside && line == "```sh";
    else if (inside && continued)
      commands.back() += line;
    else if (inside && !line.empty())
      commands.push_back(line);
    continued = inside && !line.empty() && line.back() == '\\';
    if (continued) commands.back().pop_back();
  }
  return commands;
}

bool mentions(const std::string& command, const std::string& word)
{
  return command.find(word) != std::string::npos;
}

/** Scripts of the repository install, build and test, and are not run from within a test. */
bool isScript(const std::string& command) { return command.rfind("scripts/", 0) == 0; }

/** Needs a screen, or logs that Debian does not ship. */
bool canRun(const std::string& command)
{
  const bool hasData = std::getenv("PSMKS_DATA_DIR") != nullptr || !mentions(command, "_DATA_DIR");
  return hasData && !mentions(command, "--view");
}

/** Sets of pairs are generated with a few pairs each, to be quick. */
std::string shortened(const std::string& command)
{
  const bool generates = mentions(command, "psmks-benchmark pairs") && mentions(command, "--seed");
  return generates ? std::regex_replace(command, std::regex("--seed"), "--pairs 2 --seed")
                   : command;
}

/** Runs commands as one script, in a folder that has the repository's config beside it.
 *  @return with the command that failed in its errors */
ProgramRun runScript(const std::vector<std::string>& commands)
{
  const test::ScratchFolder folder;
  std::filesystem::create_directory_symlink(kSource + "/config", folder.path("config"));
  std::ofstream script(folder.path("commands.sh"));
  script << "set -eu\ntrap 'echo \"failed: $BASH_COMMAND\" >&2' ERR\ncd '" << folder.path("")
         << "'\nexport PATH='" << kPrograms << "':\"$PATH\"\nexport LD_LIBRARY_PATH='" << kLibraries
         << "'\n";
  for (const std::string& command : commands) script << command << '\n';
  script.close();
  return runProgram("bash '" + folder.path("commands.sh") + "'");
}

/** Of a command that is not run, every flag is one that its program knows. */
void expectFlagsAreKnown(const std::string& command)
{
  std::istringstream words(command);
  std::string program, subcommand;
  words >> program >> subcommand;
  if (program != "psmks-benchmark") subcommand.clear();
  const ProgramRun help =
      runProgram("'" + kPrograms + "/" + program + "' " + subcommand + " --help");
  ASSERT_EQ(help.exitCode, 0) << command;
  const std::regex flag(R"((^|\s)(--[a-z][A-Za-z_-]*))");
  for (std::sregex_iterator i(command.begin(), command.end(), flag), none; i != none; ++i)
    EXPECT_TRUE(test::says(help.output, {(*i)[2].str()})) << command;
}
}  // namespace

class GuideCommands : public testing::TestWithParam<std::string>
{
};

TEST_P(GuideCommands, Run)
{
  std::vector<std::string> runnable;
  for (const std::string& command : commandsOf(GetParam()))
  {
    if (isScript(command)) continue;
    if (canRun(command))
      runnable.push_back(shortened(command));
    else
      expectFlagsAreKnown(command);
  }
  const ProgramRun run = runScript(runnable);
  EXPECT_EQ(run.exitCode, 0) << run.errors;
}

INSTANTIATE_TEST_SUITE_P(Pages, GuideCommands, testing::ValuesIn(kPages),
                         [](const auto& page)
                         { return std::regex_replace(page.param, std::regex("[^A-Za-z]"), "_"); });

TEST(Guide, MarksItsCommands)
{
  std::size_t commands = 0;
  for (const std::string& page : kPages)
  {
    commands += commandsOf(page).size();
    EXPECT_FALSE(
        std::regex_search(fileText(kSource + "/" + page), std::regex("```\n(log=.*\n)?psmks-")))
        << page << ": a block of commands begins with ```sh";
  }
  EXPECT_GE(commands, 40U);
}
}  // namespace psmks
