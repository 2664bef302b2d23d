/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/LogsCommand.h>
#include <apps/support/ExitCode.h>
#include <apps/support/GroundTruth.h>
#include <apps/support/Progress.h>
#include <psmks/mrpt/PairMatcher.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

namespace psmks
{
namespace
{
constexpr const char* kNoMatcher = "guess";

bool isUsable(const Log& log)
{
  return std::any_of(log.scans.begin(), log.scans.end(),
                     [](const LogScan& scan) { return hasReturns(scan.scan); });
}

bool everyMatchFailed(const std::vector<LogRun>& runs)
{
  std::size_t matches = 0, failures = 0;
  for (const auto& run : runs)
  {
    if (run.matcher == kNoMatcher) continue;
    matches += run.summary.matches;
    failures += run.summary.failures();
  }
  return matches > 0 && failures == matches;
}
}  // namespace

LogsCommand::LogsCommand(CLI::App& app) : matchers_(pairMatcherNames())
{
  app.add_option("LOG", paths_, "MRPT rawlogs, compressed or not")->required();
  app.add_option("--matchers", matchers_, "see psmks-benchmark matchers; 'guess' is the odometry")
      ->delimiter(',')
      ->capture_default_str();
  app.add_option("--references", references_, "the scan to match against")
      ->delimiter(',')
      ->check(CLI::IsMember(references_))
      ->capture_default_str();
  app.add_option("--ground-truth", groundTruth_,
                 "true trajectory of the one LOG; default: X.gt.tum, X.GT.txt or X.rawlog.GT.txt "
                 "beside X.rawlog, where there is one")
      ->type_name("FILE");
  app.add_option("--max-scans", maxScans_, "of each log; 0 = all")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_option("--repeats", repeats_, "interleaved; times are those of the fastest")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--config", configPath_, "options, as psmks-slam reads them")->type_name("INI");
  app.add_option("--set", assignments_, "one option, over --config")
      ->type_name("SECTION.KEY=VALUE");
  output_.addFlags(app);
}

int LogsCommand::run()
{
  setOptions();
  output_.open();
  const std::vector<Log> logs = readLogs();

  std::vector<Table> tables;
  std::vector<LogRun> all;
  for (const auto& log : logs)
  {
    const std::vector<LogRun> some = runs(log);
    tables.push_back(logTable(log.title, some));
    all.insert(all.end(), some.begin(), some.end());
  }
  if (!tables.empty()) output_.write(tables);

  if (damaged_) return kInputDamaged;
  if (tables.empty()) return kNothingToDo;
  return everyMatchFailed(all) ? kEveryMatchFailed : kOk;
}

std::vector<LogRun> LogsCommand::runs(const Log& log)
{
  const std::vector<Method> methods = chosenMethods();
  std::vector<LogRun> runs(methods.size());
  Progress progress(log.title);
  const double total = static_cast<double>(methods.size()) * repeats_;
  int done = 0;
  for (int repeat = 0; repeat < repeats_; ++repeat)
    for (std::size_t m = 0; m < methods.size(); ++m)
    {
      LogRun run = runLog(log, methods[m].first, methods[m].second, options_);
      if (run.time_s < runs[m].time_s) runs[m] = std::move(run);
      progress.show(++done / total);
    }
  return runs;
}

/** The odometry needs no more than one choice of references: it is the same with all. */
std::vector<LogsCommand::Method> LogsCommand::chosenMethods() const
{
  std::vector<Method> methods;
  for (const auto& matcher : matchers_)
    for (const auto& reference : references_)
      if (matcher != kNoMatcher || reference == references_.front())
        methods.emplace_back(matcher, reference);
  return methods;
}

void LogsCommand::setOptions()
{
  if (!groundTruth_.empty() && paths_.size() > 1)
    throw CLI::ValidationError("--ground-truth", "belongs to one LOG, but there are several");
  if (!configPath_.empty()) options_.load(configPath_);
  for (const auto& assignment : assignments_) options_.set(assignment);
  for (const auto& matcher : matchers_) makePairMatcher(matcher, options_.matching.matcher);
  for (const auto& path : paths_) refuseCarmen(path);
}

std::vector<Log> LogsCommand::readLogs()
{
  std::vector<Log> logs;
  for (const auto& path : paths_)
  {
    Log log = readLog(path);
    if (isUsable(log)) logs.push_back(std::move(log));
  }
  return logs;
}

Log LogsCommand::readLog(const std::string& path)
{
  Log log;
  log.title = std::filesystem::path(path).stem().string();
  RawlogReader reader(path);
  ScanConverter converter;
  const auto wanted = static_cast<std::size_t>(maxScans_);
  for (LaserFrame frame; (wanted == 0 || log.scans.size() < wanted) && reader.next(frame);)
    log.scans.push_back(toLogScan(frame, converter, options_.matching));
  if (!reader.damage().empty())
  {
    damaged_ = true;
    std::cerr << "psmks-benchmark: '" << path << "': " << reader.damage() << '\n';
  }
  else if (!isUsable(log))
    std::cerr << "psmks-benchmark: '" << path << "' holds no usable 2D laser scan\n";
  if (const auto truth = groundTruthOf(path)) log.groundTruth = readGroundTruth(*truth);
  return log;
}

std::optional<std::string> LogsCommand::groundTruthOf(const std::string& log) const
{
  return groundTruth_.empty() ? groundTruthBeside(log) : std::make_optional(groundTruth_);
}
}  // namespace psmks
