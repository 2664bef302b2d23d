/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-benchmark/CommonFlags.h>
#include <apps/psmks-benchmark/Pictures.h>
#include <apps/psmks-benchmark/TableOutput.h>
#include <apps/psmks-benchmark/convergence/Convergence.h>
#include <apps/psmks-benchmark/pairs/PairsInput.h>
#include <apps/support/ExitCode.h>

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

namespace psmks
{
/** The command `psmks-benchmark convergence SET...`: the success of matchers over the distance of
 * the guess from the truth, as tables and as a picture for each matcher. */
class ConvergenceCommand
{
 public:
  explicit ConvergenceCommand(CLI::App& app);

  /** Does the work.
   *  @throws CLI::Error, OptionError for flags and options that cannot be accepted */
  ExitCode run();

 private:
  struct SetResult
  {
    std::string title;
    std::vector<ConvergenceMap> maps;  //!< one for each matcher
  };

  void measure(const PairsInput& input);
  void write();
  void savePictures();
  std::string page(const std::vector<Table>& tables) const;

  std::vector<std::string> sets_;
  int pairs_ = 50;
  int steps_ = ConvergenceGrid::kSteps;
  double maxDistance_m_ = ConvergenceGrid::kMaxDistance_m;
  double maxRotation_deg_ = ConvergenceGrid::kMaxRotation_deg;
  OptionFlags optionFlags_;
  std::string folder_, htmlPath_;
  ConvergenceOptions options_;
  TableOutput output_;

  std::vector<SetResult> results_;
  std::optional<Pictures> pictures_;
  bool damaged_ = false;
};
}  // namespace psmks
