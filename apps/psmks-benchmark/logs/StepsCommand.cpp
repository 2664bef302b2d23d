/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/logs/StepPairs.h>
#include <apps/psmks-benchmark/logs/StepsCommand.h>

#include <iostream>

namespace psmks
{
namespace
{
constexpr PairError kSuccess{0.15, degToRad(2)};

std::string titleOf(const Log& log, int every, const StepPairs& steps)
{
  std::string title = log.title + " every " + std::to_string(every) + ": " +
                      std::to_string(steps.pairs.size()) + " pairs";
  if (steps.withoutOverlap > 0)
    title += "; " + std::to_string(steps.withoutOverlap) + " left out that share too little";
  if (steps.withoutTruth > 0)
    title += "; " + std::to_string(steps.withoutTruth) + " left out without a truth";
  return title;
}
}  // namespace

StepsCommand::StepsCommand(CLI::App& app) : benchmark_(app, kSuccess)
{
  benchmark_.input().addGroundTruthFlag(app);
  app.add_option("--every", every_, "scans: 1 = all of the log, 2 = every other one, ...")
      ->delimiter(',')
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  addGuessFlag(app, guesses_);
}

ExitCode StepsCommand::run()
{
  return benchmark_.run([this](const Log& log, const SlamOptions& options)
                        { return pairs(log, options.odometry); });
}

std::vector<LogPairs> StepsCommand::pairs(const Log& log, const OdometryOptions& odometry) const
{
  std::vector<LogPairs> sets;
  if (!log.groundTruth)
    std::cerr << "psmks-benchmark: '" << log.title << "' has no true trajectory\n";
  for (const int every : every_)
  {
    StepPairs steps = stepPairs(log, every, odometry);
    LogPairs set{titleOf(log, every, steps), std::move(steps.pairs), {}};
    for (const std::string& guess : guesses_)
      set.guesses.push_back(guess == kZeroGuess ? zeroGuesses(set.pairs) : steps.odometry);
    sets.push_back(std::move(set));
  }
  return sets;
}
}  // namespace psmks
