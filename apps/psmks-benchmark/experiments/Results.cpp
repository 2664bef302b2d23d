/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/experiments/Results.h>
#include <psmks/eval/Statistics.h>

#include <algorithm>

namespace psmks
{
namespace
{
Spread spreadOf(const std::vector<double>& values)
{
  if (values.empty()) return {};
  const auto [smallest, largest] = std::minmax_element(values.begin(), values.end());
  return {mean(values), *smallest, *largest};
}
}  // namespace

DriveResult summarise(const Drive& drive, const std::vector<MethodRun>& runs)
{
  const Recording& recording = drive.recording;
  DriveResult result{drive.plan,
                     recording.distance_m(),
                     recording.turns(),
                     recording.longestStandstill_s(),
                     recording.collisions(),
                     {}};
  for (const auto& run : runs) result.methods.emplace_back(run.method, run.figures);
  return result;
}

const MethodFigures* DriveResult::find(const std::string& methodKey) const
{
  for (const auto& [method, figures] : methods)
    if (method.key == methodKey) return &figures;
  return nullptr;
}

std::vector<ResultGroup> grouped(const std::vector<DriveResult>& results)
{
  std::vector<ResultGroup> groups;
  for (const auto& result : results)
  {
    const auto isSame = [&result](const ResultGroup& group)
    { return group.site == result.plan.site && group.maxRange_m == result.plan.maxRange_m; };
    auto group = std::find_if(groups.begin(), groups.end(), isSame);
    if (group == groups.end())
      group = groups.insert(groups.end(), {result.plan.site, result.plan.maxRange_m, {}});
    group->drives.push_back(result);
  }
  return groups;
}

Spread spread(const ResultGroup& group, const std::string& methodKey,
              const std::function<double(const MethodFigures&)>& figure)
{
  std::vector<double> values;
  for (const auto& drive : group.drives)
    if (const MethodFigures* figures = drive.find(methodKey)) values.push_back(figure(*figures));
  return spreadOf(values);
}

Spread spread(const ResultGroup& group, const std::function<double(const DriveResult&)>& figure)
{
  std::vector<double> values;
  for (const auto& drive : group.drives) values.push_back(figure(drive));
  return spreadOf(values);
}
}  // namespace psmks
