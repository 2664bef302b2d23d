/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-benchmark/Guesses.h>
#include <apps/support/SlamOptions.h>
#include <psmks/core/MatcherOptions.h>

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace psmks
{
/** The matcher that keeps its guess. */
constexpr const char* kNoMatcher = "guess";

/** Of which matchers' time others are told as multiples. */
constexpr const char* kBaseline = "icp-classic";

// Flags that mean the same in every command that has them. What a variable holds is the default.

/** --matchers */
void addMatchersFlag(CLI::App& app, std::vector<std::string>& matchers);

/** --repeats */
void addRepeatsFlag(CLI::App& app, int& repeats);

/** --guess: "zero", "odometry" or both */
void addGuessFlag(CLI::App& app, std::vector<std::string>& guesses);

/** --sensor-file, --config and --set: each over those before */
class OptionFlags
{
 public:
  void addTo(CLI::App& app);

  /** @throws OptionError for what the flags name and cannot be accepted */
  SlamOptions options() const;

 private:
  std::string sensorPath_, configPath_;
  std::vector<std::string> assignments_;
};

/** The names of those that were built. */
std::vector<std::string> builtMatchers(const std::vector<std::string>& names);

/** @throws OptionError for a matcher that does not exist or options that it does not accept */
void checkMatchers(const std::vector<std::string>& names, const MatcherOptions& options);
}  // namespace psmks
