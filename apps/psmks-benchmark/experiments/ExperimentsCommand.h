/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-benchmark/CommonFlags.h>
#include <apps/psmks-benchmark/Pictures.h>
#include <apps/psmks-benchmark/TableOutput.h>
#include <apps/psmks-benchmark/experiments/Results.h>
#include <apps/support/ExitCode.h>

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

namespace psmks
{
/** The command `psmks-benchmark experiments`, which repeats the paper's experiments on simulated
 * drives. */
class ExperimentsCommand
{
 public:
  explicit ExperimentsCommand(CLI::App& app);

  /** Does the work.
   *  @throws CLI::Error, OptionError for flags and options that cannot be accepted */
  ExitCode run();

 private:
  void shorten();
  void setOptions();
  std::vector<DrivePlan> plans() const;
  DriveResult measure(const DrivePlan& plan);
  bool isPictured(const DrivePlan& plan) const;
  void draw(const Drive& drive, const std::vector<MethodRun>& runs);
  void save(const std::vector<DriveResult>& results);

  bool quick_ = false;
  unsigned firstSeed_ = 1;
  unsigned seeds_ = 10;
  double minutes_ = 10;
  std::vector<std::string> worlds_;
  std::vector<double> ranges_m_{30, 8};
  std::vector<std::string> methodKeys_;
  OptionFlags optionFlags_;
  std::string folder_;
  TableOutput output_;

  std::vector<Method> methods_;
  MatcherOptions matcherOptions_;
  OdometryOptions odometryOptions_;
  std::optional<Pictures> pictures_;
};
}  // namespace psmks
