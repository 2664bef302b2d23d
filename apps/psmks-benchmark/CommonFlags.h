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
/** The matcher that returns its guess. */
constexpr const char* kNoMatcher = "guess";

/** The matcher whose time is the unit of the column of time ratios. */
constexpr const char* kBaseline = "icp-classic";

// Flags that have the same meaning in all commands. The values of the variables are the defaults.

/** Adds --matchers. */
void addMatchersFlag(CLI::App& app, std::vector<std::string>& matchers);

/** Adds --repeats. */
void addRepeatsFlag(CLI::App& app, int& repeats);

/** Adds --guess, with the values "zero" and "odometry". */
void addGuessFlag(CLI::App& app, std::vector<std::string>& guesses);

/** The flags --sensor-file, --config and --set. Each has priority over those before it. */
class OptionFlags
{
 public:
  void addTo(CLI::App& app);

  /** The options that the flags set.
   *  @throws OptionError for a file or an option that cannot be accepted */
  SlamOptions options() const;

 private:
  std::string sensorPath_, configPath_;
  std::vector<std::string> assignments_;
};

/** The matchers among these that are part of this build. */
std::vector<std::string> builtMatchers(const std::vector<std::string>& names);

/** Checks that matchers can be made.
 *  @throws OptionError for a matcher that does not exist or options that it does not accept */
void checkMatchers(const std::vector<std::string>& names, const MatcherOptions& options);
}  // namespace psmks
