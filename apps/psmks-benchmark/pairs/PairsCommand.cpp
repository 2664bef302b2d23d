/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/convergence/ConvergenceFigures.h>
#include <apps/psmks-benchmark/pairs/PairsCommand.h>
#include <apps/support/Progress.h>
#include <apps/support/StopSignal.h>
#include <psmks/matchers/PairMatcher.h>

#include <algorithm>
#include <iostream>

namespace psmks
{
PairsCommand::PairsCommand(CLI::App& app)
{
  options_.matchers = builtMatchers({"psmks", "psmks-ceres", "psmks-paper", kBaseline, kNoMatcher});
  addInputFlags(app);
  addMatchFlags(app);
  output_.addFlags(app);
  app.add_option("--convergence", convergencePairs_,
                 "pairs of each set whose area of convergence --html shows; 0 = none")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
}

void PairsCommand::addInputFlags(CLI::App& app)
{
  app.add_option("SET", sets_, "files of scan pairs (.pairs or .pairs.gz), or names of sets");
  app.add_flag("--list-sets", listsSets_, "print the names of the sets that can be generated");
  addChoiceFlags(app, choice_);
  app.add_option("--save-pairs", saveFolder_, "write each set as NAME.pairs.gz")
      ->type_name("FOLDER");
  app.add_option("--range-sigma_m", rangeSigma_m_,
                 "noise of a range, for the bound of the errors [that of the set, 0.01 for files]")
      ->check(CLI::PositiveNumber);
}

void PairsCommand::addMatchFlags(CLI::App& app)
{
  addMatchersFlag(app, options_.matchers);
  addGuessFlag(app, guesses_);
  app.add_option("--odometry-sigma_m", odometrySigma_m_,
                 "standard deviation of the odometry guess, per axis")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--odometry-sigma_deg", odometrySigma_deg_, "and of its heading")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  addRepeatsFlag(app, options_.repeats);
  app.add_flag("--sequential", options_.sequential,
               "also the time against a reference that is prepared beforehand, as in a sequence");
  optionFlags_.addTo(app);
}

ExitCode PairsCommand::run()
{
  if (listsSets_)
  {
    std::cout << listOfSets();
    return kOk;
  }
  requireInput();
  options_.matcherOptions = optionFlags_.options().matching.matcher;
  checkMatchers(options_.matchers, options_.matcherOptions);
  output_.check();

  std::vector<PairsInput> inputs;
  for (const auto& set : sets_) inputs.push_back(inputPairs(set, choice_));
  if (!saveFolder_.empty())
    for (const auto& set : inputs)
      if (!set.pairs.empty()) savePairs(saveFolder_, set);
  for (const auto& set : inputs)
    if (!isToStop()) match(set);
  output_.write(tables());

  const auto isDamaged = [](const PairsInput& input) { return input.isDamaged; };
  return output_.exitCode(std::any_of(inputs.begin(), inputs.end(), isDamaged));
}

void PairsCommand::requireInput() const
{
  if (sets_.empty()) throw CLI::RequiredError("SET: a file of scan pairs or the name of a set");
  for (const auto& set : sets_)
    if (looksLikeASet(set)) pairFamily(set);
}

void PairsCommand::match(const PairsInput& input)
{
  if (input.pairs.empty()) return;

  PairsSetResult result;
  result.title = input.title;
  result.pairs = input.pairs;
  result.hasMovingObjects = input.hasMovingObjects;
  const RangeNoise noise = rangeSigma_m_ > 0 ? RangeNoise{rangeSigma_m_} : input.rangeNoise;
  for (const ScanPair& pair : input.pairs)
    result.bounds.push_back(pairBound(pair.reference, pair.current, pair.T_ref_cur_true, noise));
  {
    Progress progress(input.title);
    result.runs = runPairs(input.pairs, guesses(input.pairs), options_,
                           [&](double share) { progress.show(share); });
  }
  if (isToStop()) return;  // a part of a set would be compared with whole ones
  if (output_.hasPage() && convergencePairs_ > 0) result.convergence = convergence(input.pairs);
  output_.add(std::move(result));
}

std::vector<Guesses> PairsCommand::guesses(const std::vector<ScanPair>& pairs) const
{
  std::vector<Guesses> kinds;
  for (const std::string& name : guesses_)
    kinds.push_back(name == kZeroGuess
                        ? zeroGuesses(pairs)
                        : odometryGuesses(pairs, odometrySigma_m_, degToRad(odometrySigma_deg_)));
  return kinds;
}

std::vector<Panel> PairsCommand::convergence(const std::vector<ScanPair>& pairs) const
{
  ConvergenceOptions options;
  options.matchers = options_.matchers;
  options.matcherOptions = options_.matcherOptions;
  options.seed = choice_.seed;
  const auto count = std::min(pairs.size(), static_cast<std::size_t>(convergencePairs_));
  const std::vector<ScanPair> some(pairs.begin(), pairs.begin() + static_cast<long>(count));
  Progress progress("convergence");
  const auto maps = measureConvergence(some, options, [&](double share) { progress.show(share); });
  return convergencePictures(options.grid, maps);
}

std::vector<Table> PairsCommand::tables() const
{
  std::vector<Table> tables = output_.tables();
  const auto& sets = output_.results();
  const auto isStatic = [](const PairsSetResult& set) { return !set.hasMovingObjects; };
  if (std::count_if(sets.begin(), sets.end(), isStatic) > 1)
    tables.push_back(tableOf(pooledStaticSets(sets), kBaseline));
  return tables;
}
}  // namespace psmks
