/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/ExitCode.h>
#include <apps/psmks-benchmark/PairsCommand.h>

#include <CLI/CLI.hpp>
#include <iostream>

int main(int argc, char** argv)
{
  CLI::App app("Compares scan matchers on the same input.", "psmks-benchmark");
  app.require_subcommand(1);
  psmks::PairsCommand pairs(*app.add_subcommand("pairs", "matchers on files of scan pairs"));

  try
  {
    app.parse(argc, argv);
    return pairs.run();
  }
  catch (const CLI::Success& help)
  {
    return app.exit(help);
  }
  catch (const std::exception& error)
  {
    std::cerr << "psmks-benchmark: " << error.what() << '\n';
    return psmks::kUsage;
  }
}
