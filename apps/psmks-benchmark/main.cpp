/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/PairsCommand.h>
#include <apps/psmks-benchmark/SegmentationCommand.h>
#include <apps/support/ExitCode.h>

#include <CLI/CLI.hpp>
#include <iostream>

int main(int argc, char** argv)
{
  CLI::App app("Compares scan matchers on the same input.", "psmks-benchmark");
  app.set_version_flag("--version", "psmks-benchmark " PSMKS_VERSION);
  app.require_subcommand(1);
  CLI::App* pairsApp = app.add_subcommand("pairs", "matchers on files of scan pairs");
  CLI::App* segmentationApp =
      app.add_subcommand("segmentation", "Kalman Segmentation on simulated scans");
  psmks::PairsCommand pairs(*pairsApp);
  psmks::SegmentationCommand segmentation(*segmentationApp);

  try
  {
    app.parse(argc, argv);
    return pairsApp->parsed() ? pairs.run() : segmentation.run();
  }
  catch (const CLI::Success& helpOrVersion)
  {
    return app.exit(helpOrVersion);
  }
  catch (const std::exception& error)
  {
    std::cerr << "psmks-benchmark: " << error.what() << '\n';
    return psmks::kUsage;
  }
}
