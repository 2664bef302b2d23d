/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/CommonFlags.h>
#include <apps/psmks-benchmark/Machine.h>
#include <apps/psmks-benchmark/pairs/PairsOutput.h>
#include <apps/psmks-benchmark/report/CommandLine.h>
#include <apps/psmks-benchmark/report/PairsPage.h>
#include <apps/support/ExitCode.h>
#include <apps/support/Outputs.h>

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

void PairsOutput::check() const
{
  tables_.check();
  if (!htmlPath_.empty()) requireCreatable("--html", htmlPath_);
  if (!dumpPath_.empty()) requireCreatable("--dump", dumpPath_);
}

void PairsOutput::dump(std::ostream& csv) const
{
  csv << dumpHeader();
  for (const PairsSetResult& set : results_)
    for (const PairsRun& run : set.runs) csv << dumpRows(run);
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
  Outputs outputs;
  if (!dumpPath_.empty()) outputs.addText(dumpPath_, [this](std::ostream& csv) { dump(csv); });
  if (hasPage())
    outputs.addText(
        htmlPath_,
        [&](std::ostream& page) {
          page << pairsPage({Machine::present().line(), commandLine()}, tables, results_);
        });
  tables_.write(tables);
  outputs.requireComplete();
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
