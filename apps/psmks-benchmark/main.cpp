/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/convergence/ConvergenceCommand.h>
#include <apps/psmks-benchmark/drives/DrivesCommand.h>
#include <apps/psmks-benchmark/experiments/ExperimentsCommand.h>
#include <apps/psmks-benchmark/experiments/SegmentationCommand.h>
#include <apps/psmks-benchmark/growth/GrowthCommand.h>
#include <apps/psmks-benchmark/logs/ClosureCommand.h>
#include <apps/psmks-benchmark/logs/LogsCommand.h>
#include <apps/psmks-benchmark/logs/MapsCommand.h>
#include <apps/psmks-benchmark/logs/SelfmatchCommand.h>
#include <apps/psmks-benchmark/logs/StepsCommand.h>
#include <apps/psmks-benchmark/pairs/MapPairsCommand.h>
#include <apps/psmks-benchmark/pairs/PairsCommand.h>
#include <apps/support/ExitCode.h>
#include <psmks/matchers/PairMatcherRegistration.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <iomanip>
#include <iostream>
#include <memory>

namespace psmks
{
namespace
{
/** The commands of the program. */
class Commands
{
 public:
  explicit Commands(CLI::App& program) : program_(program) {}

  /** Adds a command with flags of its own.
   *  @tparam Command has a constructor that adds its flags to a parser, and a function run() */
  template <class Command>
  void add(const std::string& name, const std::string& description)
  {
    CLI::App& parser = *program_.add_subcommand(name, description);
    const auto command = std::make_shared<Command>(parser);
    commands_.push_back({&parser, [command] { return command->run(); }});
  }

  void add(const std::string& name, const std::string& description, std::function<ExitCode()> run)
  {
    commands_.push_back({program_.add_subcommand(name, description), std::move(run)});
  }

  /** Runs the command that the command line names.
   *  @throws CLI::Error if it names none, or for flags that do not exist */
  ExitCode run(int argc, char** argv) const
  {
    program_.parse(argc, argv);
    const auto isNamed = [](const Entry& entry) { return entry.parser->parsed(); };
    return std::find_if(commands_.begin(), commands_.end(), isNamed)->run();
  }

 private:
  struct Entry
  {
    CLI::App* parser;
    std::function<ExitCode()> run;
  };

  CLI::App& program_;
  std::vector<Entry> commands_;
};

ExitCode listMatchers()
{
  constexpr int kNameWidth = 22;
  for (const auto& matcher : pairMatcherEntries())
    std::cout << std::left << std::setw(kNameWidth) << matcher.name << matcher.description << '\n';
  return kOk;
}

void addCommands(Commands& commands)
{
  commands.add<PairsCommand>("pairs", "matchers on files of scan pairs");
  commands.add<MapPairsCommand>("map-pairs", "maps of the scans of pairs, aligned by AlignPDF()");
  commands.add<ConvergenceCommand>("convergence", "how far from the truth a match may start");
  commands.add<LogsCommand>("logs", "matchers on logs of a robot");
  commands.add<StepsCommand>("steps", "matchers on scans of a log that follow each other");
  commands.add<SelfmatchCommand>("selfmatch",
                                 "matchers on each scan of a log and its displaced self");
  commands.add<ClosureCommand>(
      "closure", "whether three matches in a triangle miss by no more than the noise");
  commands.add<MapsCommand>("maps", "scans of a log aligned to a point map that grows");
  commands.add<GrowthCommand>("growth", "how the time of a match grows with the rays of the scans");
  commands.add<SegmentationCommand>("segmentation", "Kalman Segmentation on simulated scans");
  commands.add<ExperimentsCommand>("experiments", "the paper's experiments on simulated drives");
  commands.add<DrivesCommand>("drives", "long simulated drives: errors, time and memory");
  commands.add("matchers", "lists those that can be compared", listMatchers);
}

ExitCode run(int argc, char** argv)
{
  CLI::App program("Compares scan matchers on the same input.", "psmks-benchmark");
  program.set_version_flag("--version", "psmks-benchmark " PSMKS_VERSION);
  program.require_subcommand(1);
  Commands commands(program);
  addCommands(commands);
  try
  {
    return commands.run(argc, argv);
  }
  catch (const CLI::Success& helpOrVersion)
  {
    return static_cast<ExitCode>(program.exit(helpOrVersion));
  }
}
}  // namespace
}  // namespace psmks

int main(int argc, char** argv)
{
  return psmks::runToEnd("psmks-benchmark", [&] { return psmks::run(argc, argv); });
}
