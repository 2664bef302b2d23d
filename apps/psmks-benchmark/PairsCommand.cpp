/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/PairsCommand.h>
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

/** The file's name without folder and extensions. */
std::string tableTitle(const std::string& path)
{
  const std::string name = std::filesystem::path(path).filename().string();
  return name.substr(0, name.find(".pairs"));
}
}  // namespace

PairsCommand::PairsCommand(CLI::App& app)
{
  options_.matchers = defaultMatchers();
  app.add_option("FILE", paths_, "files of scan pairs (.pairs or .pairs.gz)")->required();
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
  app.add_option("--max-pairs", maxPairs_, "of each file; 0 = all")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_option("--config", configPath_, "options of psmks, sections [psmks.STAGE]")
      ->type_name("INI");
  app.add_option("--set", assignments_, "one option of psmks, over --config")
      ->type_name("SECTION.KEY=VALUE");
  app.add_option("--dump", dumpPath_, "write every match as CSV")->type_name("FILE");
  output_.addFlags(app);
}

int PairsCommand::run()
{
  options_.matcherOptions = matcherOptions();
  options_.odometrySigma_rad = degToRad(odometrySigma_deg_);
  options_.guesses.clear();
  for (const auto& name : guesses_) options_.guesses.push_back(guessKind(name));
  for (const auto& name : options_.matchers) makePairMatcher(name, options_.matcherOptions);
  output_.open();
  if (!dumpPath_.empty()) dump_ = createFile("--dump", dumpPath_);
  if (dump_.is_open()) dump_ << dumpHeader();

  for (const auto& path : paths_) match(path);
  if (!tables_.empty()) output_.write(tables_);

  if (damaged_) return kInputDamaged;
  if (tables_.empty()) return kNothingToDo;
  return matches_ > 0 && usableMatches_ == 0 ? kEveryMatchFailed : kOk;
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
  for (const auto& assignment : assignments_)
  {
    const auto [section, key, value] = parseAssignment(assignment);
    table.set(section, key, value);
  }
  return options;
}

std::vector<ScanPair> PairsCommand::readPairs(const std::string& path)
{
  std::vector<ScanPair> pairs;
  try
  {
    PairsReader reader(path);
    const auto wanted = static_cast<std::size_t>(maxPairs_);
    for (ScanPair pair; (maxPairs_ == 0 || pairs.size() < wanted) && reader.read(pair);)
      pairs.push_back(pair);
    if (pairs.empty()) std::cerr << "psmks-benchmark: " << path << ": holds no pair\n";
  }
  catch (const PairsFileError& error)
  {
    damaged_ = true;
    std::cerr << "psmks-benchmark: " << error.what() << '\n';
  }
  return pairs;
}

void PairsCommand::match(const std::string& path)
{
  const std::vector<ScanPair> pairs = readPairs(path);
  if (pairs.empty()) return;

  const std::string title = tableTitle(path);
  Progress progress(title);
  const auto runs = runPairs(pairs, options_, [&](double share) { progress.show(share); });
  for (const auto& run : runs)
  {
    if (dump_.is_open()) dump_ << dumpRows(run);
    if (run.matcher != kNoMatcher) countMatches(run);
  }
  tables_.push_back(pairsTable(title, runs, kBaseline));
}

void PairsCommand::countMatches(const PairsRun& run)
{
  matches_ += run.records.size();
  for (const auto& record : run.records)
    if (record.result.usable()) ++usableMatches_;
}
}  // namespace psmks
