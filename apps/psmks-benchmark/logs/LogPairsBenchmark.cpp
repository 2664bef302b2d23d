/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/logs/LogPairsBenchmark.h>
#include <apps/support/Progress.h>

namespace psmks
{
LogPairsBenchmark::LogPairsBenchmark(CLI::App& app, const PairError& success)
    : success_m_(success.translation_m), success_deg_(radToDeg(success.rotation_rad))
{
  options_.ofOneScanner = true;
  options_.matchers = {"psmks",  "psmks-paper", "psm", kBaseline, "icp-classic-tuned",
                       "icp-lm", kNoMatcher};
  input_.addLogFlags(app);
  addMatchersFlag(app, options_.matchers);
  app.add_option("--success_m", success_m_, "what a success may be off by; twice that is wrong")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--success_deg", success_deg_, "and in heading")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  addRepeatsFlag(app, options_.repeats);
  optionFlags_.addTo(app);
  output_.addFlags(app);
}

ExitCode LogPairsBenchmark::run(const MakePairs& makePairs)
{
  input_.check();
  const SlamOptions options = optionFlags_.options();
  options_.matcherOptions = options.matching.matcher;
  checkMatchers(options_.matchers, options_.matcherOptions);
  output_.check();

  for (const Log& log : input_.read(options.matching))
    for (const LogPairs& set : makePairs(log, options)) match(set);
  output_.write(output_.tables());
  return output_.exitCode(input_.isDamaged());
}

void LogPairsBenchmark::match(const LogPairs& set)
{
  if (set.pairs.empty()) return;
  PairsSetResult result;
  result.title = set.title;
  result.pairs = set.pairs;
  result.successLimit = {success_m_, degToRad(success_deg_)};
  {
    Progress progress(set.title);
    result.runs =
        runPairs(set.pairs, set.guesses, options_, [&](double share) { progress.show(share); });
  }
  output_.add(std::move(result));
}
}  // namespace psmks
