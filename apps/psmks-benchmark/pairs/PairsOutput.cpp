/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/CommonFlags.h>
#include <apps/psmks-benchmark/Machine.h>
#include <apps/psmks-benchmark/pairs/PairsOutput.h>
#include <apps/psmks-benchmark/report/CommandLine.h>
#include <apps/psmks-benchmark/report/PairsPage.h>
#include <apps/support/ExitCode.h>

namespace psmks
{
void PairsOutput::addFlags(CLI::App& command)
{
  command.add_option("--dump", dumpPath_, "write every match as CSV")->type_name("FILE");
  command
      .add_option("--html", htmlPath_,
                  "write one page: tables, distributions, the worst pairs drawn")
      ->type_name("FILE");
  tables_.addFlags(command);
}

void PairsOutput::open()
{
  tables_.open();
  if (!htmlPath_.empty()) html_ = createFile("--html", htmlPath_);
  if (!dumpPath_.empty()) dump_ = createFile("--dump", dumpPath_);
  if (dump_.is_open()) dump_ << dumpHeader();
}

void PairsOutput::add(PairsSetResult result)
{
  if (dump_.is_open())
    for (const PairsRun& run : result.runs) dump_ << dumpRows(run);
  results_.push_back(std::move(result));
}

std::vector<Table> PairsOutput::tables() const
{
  std::vector<Table> tables;
  for (const PairsSetResult& set : results_) tables.push_back(tableOf(set, kBaseline));
  return tables;
}

void PairsOutput::write(const std::vector<Table>& tables)
{
  if (tables.empty()) return;
  tables_.write(tables);
  if (html_.is_open())
    html_ << pairsPage({Machine::present().line(), commandLine()}, tables, results_);
}

ExitCode PairsOutput::exitCode(bool damaged) const
{
  if (damaged) return kInputDamaged;
  if (results_.empty()) return kNothingToDo;
  return everyMatchFailed() ? kEveryMatchFailed : kOk;
}

bool PairsOutput::everyMatchFailed() const
{
  bool anyMatch = false;
  for (const PairsSetResult& set : results_)
    for (const PairsRun& run : set.runs)
    {
      if (run.matcher == kNoMatcher) continue;
      anyMatch = anyMatch || !run.records.empty();
      for (const PairRecord& record : run.records)
        if (record.result.usable()) return false;
    }
  return anyMatch;
}
}  // namespace psmks
