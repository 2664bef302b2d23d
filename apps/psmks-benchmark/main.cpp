/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/convergence/ConvergenceCommand.h>
#include <apps/psmks-benchmark/experiments/ExperimentsCommand.h>
#include <apps/psmks-benchmark/experiments/SegmentationCommand.h>
#include <apps/psmks-benchmark/growth/GrowthCommand.h>
#include <apps/psmks-benchmark/logs/LogsCommand.h>
#include <apps/psmks-benchmark/logs/SelfmatchCommand.h>
#include <apps/psmks-benchmark/logs/StepsCommand.h>
#include <apps/psmks-benchmark/pairs/PairsCommand.h>
#include <apps/support/ExitCode.h>
#include <psmks/matchers/PairMatcherRegistration.h>

#include <CLI/CLI.hpp>
#include <iomanip>
#include <iostream>

namespace
{
int listMatchers()
{
  constexpr int kNameWidth = 22;
  for (const auto& matcher : psmks::pairMatcherEntries())
    std::cout << std::left << std::setw(kNameWidth) << matcher.name << matcher.description << '\n';
  return psmks::kOk;
}
}  // namespace

int main(int argc, char** argv)
{
  CLI::App app("Compares scan matchers on the same input.", "psmks-benchmark");
  app.set_version_flag("--version", "psmks-benchmark " PSMKS_VERSION);
  app.require_subcommand(1);
  CLI::App* pairsApp = app.add_subcommand("pairs", "matchers on files of scan pairs");
  CLI::App* convergenceApp =
      app.add_subcommand("convergence", "how far from the truth a match may start");
  CLI::App* logsApp = app.add_subcommand("logs", "matchers on logs of a robot");
  CLI::App* stepsApp =
      app.add_subcommand("steps", "matchers on scans of a log that follow each other");
  CLI::App* selfmatchApp =
      app.add_subcommand("selfmatch", "matchers on each scan of a log and its displaced self");
  CLI::App* growthApp =
      app.add_subcommand("growth", "how the time of a match grows with the rays of the scans");
  CLI::App* segmentationApp =
      app.add_subcommand("segmentation", "Kalman Segmentation on simulated scans");
  CLI::App* experimentsApp =
      app.add_subcommand("experiments", "the paper's experiments on simulated drives");
  CLI::App* matchersApp = app.add_subcommand("matchers", "lists those that can be compared");
  psmks::PairsCommand pairs(*pairsApp);
  psmks::ConvergenceCommand convergence(*convergenceApp);
  psmks::LogsCommand logs(*logsApp);
  psmks::StepsCommand steps(*stepsApp);
  psmks::SelfmatchCommand selfmatch(*selfmatchApp);
  psmks::GrowthCommand growth(*growthApp);
  psmks::SegmentationCommand segmentation(*segmentationApp);
  psmks::ExperimentsCommand experiments(*experimentsApp);

  try
  {
    app.parse(argc, argv);
    if (pairsApp->parsed()) return pairs.run();
    if (convergenceApp->parsed()) return convergence.run();
    if (logsApp->parsed()) return logs.run();
    if (stepsApp->parsed()) return steps.run();
    if (selfmatchApp->parsed()) return selfmatch.run();
    if (growthApp->parsed()) return growth.run();
    if (matchersApp->parsed()) return listMatchers();
    if (segmentationApp->parsed()) return segmentation.run();
    return experiments.run();
  }
  catch (const CLI::Success& helpOrVersion)
  {
    return app.exit(helpOrVersion);
  }
  catch (const psmks::ProgramError& error)
  {
    std::cerr << "psmks-benchmark: " << error.what() << '\n';
    return error.exitCode;
  }
  catch (const std::exception& error)
  {
    std::cerr << "psmks-benchmark: " << error.what() << '\n';
    return psmks::kUsage;
  }
}
