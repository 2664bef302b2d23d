/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/Machine.h>
#include <apps/psmks-benchmark/logs/LogsCommand.h>
#include <apps/psmks-benchmark/report/CommandLine.h>
#include <apps/support/Progress.h>
#include <apps/support/StopSignal.h>
#include <apps/support/TextFile.h>

namespace psmks
{
namespace
{
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

LogsCommand::LogsCommand(CLI::App& app)
{
  input_.addLogFlags(app);
  input_.addGroundTruthFlag(app);
  input_.addRelationsFlag(app);
  addMatchersFlag(app, matchers_);
  app.add_option("--references", references_, "the scan to match against")
      ->delimiter(',')
      ->check(CLI::IsMember(references_))
      ->capture_default_str();
  addRepeatsFlag(app, repeats_);
  optionFlags_.addTo(app);
  output_.addFlags(app);
  app.add_option("--html", htmlPath_, "write one page: tables, the worst motions drawn")
      ->type_name("FILE");
  app.add_option("--draw-worst", drawn_, "motions of each run on that page")->capture_default_str();
}

ExitCode LogsCommand::run()
{
  input_.check();
  options_ = optionFlags_.options();
  checkMatchers(matchers_, options_.matching.matcher);
  output_.check();
  if (!htmlPath_.empty()) requireCreatable("--html", htmlPath_);

  std::vector<Table> tables;
  std::vector<LogRun> all;
  for (const auto& log : input_.read(options_.matching))
  {
    if (isToStop()) break;
    const std::vector<LogRun> some = runs(log);
    tables.push_back(logTable(log.title, some));
    all.insert(all.end(), some.begin(), some.end());
  }
  if (!tables.empty()) write(tables, all);

  if (input_.isDamaged()) return kInputDamaged;
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
      LogRun run = runLog(log, methods[m].first, methods[m].second, options_,
                          htmlPath_.empty() ? 0 : drawn_);
      if (run.time_s < runs[m].time_s) runs[m] = std::move(run);
      progress.show(++done / total);
    }
  return runs;
}

void LogsCommand::write(const std::vector<Table>& tables, const std::vector<LogRun>& runs)
{
  output_.write(tables);
  if (htmlPath_.empty()) return;
  std::vector<DrawnRun> drawn;
  for (const LogRun& run : runs)
    if (!run.worst.records.empty()) drawn.push_back(run.worst);
  writeTextFile(htmlPath_,
                [&](std::ostream& page) {
                  page << logsPage({Machine::present().line(), commandLine()}, tables, drawn);
                });
}

/** The matcher that keeps its guess is run with one policy only, for its result is the same with
 * all of them. */
std::vector<LogsCommand::Method> LogsCommand::chosenMethods() const
{
  std::vector<Method> methods;
  for (const auto& matcher : matchers_)
    for (const auto& reference : references_)
      if (matcher != kNoMatcher || reference == references_.front())
        methods.emplace_back(matcher, reference);
  return methods;
}
}  // namespace psmks
