/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/Machine.h>
#include <apps/psmks-benchmark/PairsCommand.h>
#include <apps/psmks-benchmark/report/CommandLine.h>
#include <apps/psmks-benchmark/report/PairsPage.h>
#include <apps/support/Assignment.h>
#include <apps/support/ExitCode.h>
#include <apps/support/Progress.h>
#include <mrpt/config/CConfigFile.h>
#include <psmks/mrpt/ConfigFile.h>
#include <psmks/mrpt/PairMatcher.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

namespace psmks
{
namespace
{
constexpr const char* kBaseline = "icp-classic";
constexpr const char* kNoMatcher = "guess";

/** Those of the usual matchers that were built. */
std::vector<std::string> defaultMatchers()
{
  const auto known = pairMatcherNames();
  std::vector<std::string> names;
  for (const char* name : {"psmks", "psmks-ceres", "psmks-paper", kBaseline, kNoMatcher})
    if (std::find(known.begin(), known.end(), name) != known.end()) names.emplace_back(name);
  return names;
}

std::string joined(const std::vector<std::string>& words)
{
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : ",") + word;
  return text;
}

GuessKind guessKind(const std::string& name)
{
  for (const GuessKind kind : {GuessKind::Zero, GuessKind::Odometry})
    if (toString(kind) == name) return kind;
  throw CLI::ValidationError("--guess", "'" + name + "' is not known, allowed: zero | odometry");
}
}  // namespace

PairsCommand::PairsCommand(CLI::App& app)
{
  options_.matchers = defaultMatchers();
  addInputFlags(app);
  addMatchFlags(app);
  app.add_option("--dump", dumpPath_, "write every match as CSV")->type_name("FILE");
  app.add_option("--html", htmlPath_,
                 "write one page: tables, distributions, the worst pairs drawn")
      ->type_name("FILE");
  output_.addFlags(app);
}

void PairsCommand::addInputFlags(CLI::App& app)
{
  app.add_option("SET", sets_, "files of scan pairs (.pairs or .pairs.gz), or names of sets");
  app.add_flag("--list-sets", listsSets_, "print the names of the sets that can be generated");
  app.add_option("--seed", seed_, "of generated sets")->capture_default_str();
  app.add_option("--pairs", generatedPairs_, "in each generated set")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--max-pairs", maxPairs_, "of each file; 0 = all")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_option("--save-pairs", saveFolder_, "write each set as NAME.pairs.gz")
      ->type_name("FOLDER");
  app.add_option("--range-sigma_m", rangeSigma_m_,
                 "noise of a range, for the bound of the errors [that of the set, 0.01 for files]")
      ->check(CLI::PositiveNumber);
}

void PairsCommand::addMatchFlags(CLI::App& app)
{
  app.add_option("--matchers", options_.matchers, "of " + joined(pairMatcherNames()))
      ->delimiter(',')
      ->capture_default_str();
  app.add_option("--guess", guesses_, "zero (no covariance), odometry (with covariance), or both")
      ->delimiter(',')
      ->capture_default_str();
  app.add_option("--odometry-sigma_m", options_.odometrySigma_m,
                 "standard deviation of the odometry guess, per axis")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--odometry-sigma_deg", odometrySigma_deg_, "and of its heading")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--repeats", options_.repeats,
                 "interleaved; the time of a pair is the smallest of its repeats")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_flag("--sequential", options_.sequential,
               "also the time against a reference that is prepared beforehand, as in a sequence");
  app.add_option("--config", configPath_, "options of psmks, sections [psmks.STAGE]")
      ->type_name("INI");
  app.add_option("--set", assignments_, "one option of psmks, over --config")
      ->type_name("SECTION.KEY=VALUE");
}

int PairsCommand::run()
{
  if (listsSets_)
  {
    std::cout << listOfSets();
    return kOk;
  }
  requireInput();
  settleOptions();
  output_.open();
  if (!htmlPath_.empty()) html_ = createFile("--html", htmlPath_);
  if (!dumpPath_.empty()) dump_ = createFile("--dump", dumpPath_);
  if (dump_.is_open()) dump_ << dumpHeader();

  std::vector<PairsInput> inputs;
  for (const auto& set : sets_) inputs.push_back(input(set));
  if (!saveFolder_.empty())
    for (const auto& set : inputs)
      if (!set.pairs.empty()) savePairs(saveFolder_, set);
  for (const auto& set : inputs) match(set);
  if (!results_.empty()) write(tables());

  if (damaged_) return kInputDamaged;
  if (results_.empty()) return kNothingToDo;
  return matches_ > 0 && usableMatches_ == 0 ? kEveryMatchFailed : kOk;
}

void PairsCommand::requireInput() const
{
  if (sets_.empty()) throw CLI::RequiredError("SET: a file of scan pairs or the name of a set");
  for (const auto& set : sets_)
    if (looksLikeASet(set)) pairFamily(set);
}

void PairsCommand::settleOptions()
{
  options_.matcherOptions = matcherOptions();
  options_.odometrySigma_rad = degToRad(odometrySigma_deg_);
  options_.guesses.clear();
  for (const auto& name : guesses_) options_.guesses.push_back(guessKind(name));
  for (const auto& name : options_.matchers) makePairMatcher(name, options_.matcherOptions);
}

MatcherOptions PairsCommand::matcherOptions() const
{
  MatcherOptions options;
  OptionTable table = optionTable(options);
  if (!configPath_.empty())
  {
    if (!std::filesystem::is_regular_file(configPath_))
      throw CLI::ValidationError("--config", "'" + configPath_ + "' is no file");
    loadOptions(table, mrpt::config::CConfigFile(configPath_), "psmks");
  }
  assignOptions(table, assignments_);
  return options;
}

PairsInput PairsCommand::input(const std::string& argument)
{
  PairsInput input;
  try
  {
    if (isGenerated(argument))
      input = generatedPairs(pairFamily(argument), seed_, generatedPairs_);
    else
      readPairs(argument, maxPairs_, input);
    if (input.pairs.empty()) std::cerr << "psmks-benchmark: " << argument << ": holds no pair\n";
  }
  catch (const PairsFileError& error)
  {
    damaged_ = true;
    std::cerr << "psmks-benchmark: " << error.what() << '\n';
  }
  return input;
}

void PairsCommand::match(const PairsInput& input)
{
  if (input.pairs.empty()) return;

  PairsSetResult result{input.title, input.pairs, {}, {}, input.hasMovingObjects};
  const double sigma_m = rangeSigma_m_ > 0 ? rangeSigma_m_ : input.rangeSigma_m;
  for (const ScanPair& pair : input.pairs)
    result.bounds.push_back(pairBound(pair.reference, pair.current, pair.T_ref_cur_true, sigma_m));

  Progress progress(input.title);
  result.runs = runPairs(input.pairs, options_, [&](double share) { progress.show(share); });
  for (const auto& run : result.runs)
  {
    if (dump_.is_open()) dump_ << dumpRows(run);
    if (run.matcher != kNoMatcher) countMatches(run);
  }
  results_.push_back(std::move(result));
}

std::vector<Table> PairsCommand::tables() const
{
  std::vector<Table> tables;
  const auto add = [&tables](const PairsSetResult& set)
  { tables.push_back(pairsTable(set.title, set.runs, summarize(set.bounds), kBaseline)); };
  for (const PairsSetResult& set : results_) add(set);
  const auto isStatic = [](const PairsSetResult& set) { return !set.hasMovingObjects; };
  if (std::count_if(results_.begin(), results_.end(), isStatic) > 1)
    add(pooledStaticSets(results_));
  return tables;
}

void PairsCommand::write(const std::vector<Table>& tables)
{
  output_.write(tables);
  if (html_.is_open())
    html_ << pairsPage({Machine::present().line(), commandLine()}, tables, results_);
}

void PairsCommand::countMatches(const PairsRun& run)
{
  matches_ += run.records.size();
  for (const auto& record : run.records)
    if (record.result.usable()) ++usableMatches_;
}
}  // namespace psmks
