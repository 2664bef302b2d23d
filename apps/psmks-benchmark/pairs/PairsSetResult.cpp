/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/pairs/PairsSetResult.h>

namespace psmks
{
namespace
{
template <class Value>
void append(std::vector<Value>& values, const std::vector<Value>& more)
{
  values.insert(values.end(), more.begin(), more.end());
}

void appendRecords(std::vector<PairsRun>& runs, const PairsRun& more)
{
  for (PairsRun& run : runs)
    if (run.matcher == more.matcher && run.guess == more.guess)
      return append(run.records, more.records);
  runs.push_back(more);
}
}  // namespace

Table tableOf(const PairsSetResult& set, const std::string& baseline)
{
  const auto bound = set.bounds.empty() ? std::nullopt : std::make_optional(summarize(set.bounds));
  return pairsTable(set.title, set.runs, bound, baseline, set.successLimit);
}

PairsSetResult pooledStaticSets(const std::vector<PairsSetResult>& sets)
{
  PairsSetResult pool;
  pool.title = "all sets without moving objects";
  for (const PairsSetResult& set : sets)
  {
    if (set.hasMovingObjects) continue;
    append(pool.bounds, set.bounds);
    for (const PairsRun& run : set.runs) appendRecords(pool.runs, run);
  }
  return pool;
}
}  // namespace psmks
