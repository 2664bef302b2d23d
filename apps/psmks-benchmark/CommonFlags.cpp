/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/CommonFlags.h>
#include <psmks/matchers/PairMatcher.h>

#include <algorithm>

namespace psmks
{
void addMatchersFlag(CLI::App& app, std::vector<std::string>& matchers)
{
  app.add_option("--matchers", matchers, "see psmks-benchmark matchers; 'guess' matches nothing")
      ->delimiter(',')
      ->capture_default_str();
}

void addRepeatsFlag(CLI::App& app, int& repeats)
{
  app.add_option("--repeats", repeats, "interleaved; the smallest time counts")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
}

void addGuessFlag(CLI::App& app, std::vector<std::string>& guesses)
{
  app.add_option("--guess", guesses, "zero (no covariance), odometry (with covariance), or both")
      ->delimiter(',')
      ->check(CLI::IsMember(std::vector<std::string>{kZeroGuess, kOdometryGuess}))
      ->capture_default_str();
}

void OptionFlags::addTo(CLI::App& app)
{
  app.add_option("--sensor-file", sensorPath_,
                 "options that describe the scanner, see config/sensors")
      ->type_name("INI");
  app.add_option("--config", configPath_, "options, as psmks-slam reads them, over --sensor-file")
      ->type_name("INI");
  app.add_option("--set", assignments_, "one option, over --config")
      ->type_name("SECTION.KEY=VALUE");
}

SlamOptions OptionFlags::options() const
{
  SlamOptions options;
  if (!sensorPath_.empty()) options.load(sensorPath_);
  if (!configPath_.empty()) options.load(configPath_);
  for (const auto& assignment : assignments_) options.set(assignment);
  return options;
}

std::vector<std::string> builtMatchers(const std::vector<std::string>& names)
{
  const auto built = pairMatcherNames();
  std::vector<std::string> result;
  for (const std::string& name : names)
    if (std::find(built.begin(), built.end(), name) != built.end()) result.push_back(name);
  return result;
}

void checkMatchers(const std::vector<std::string>& names, const MatcherOptions& options)
{
  for (const auto& name : names) makePairMatcher(name, options);
}
}  // namespace psmks
