/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/eval/StampIndex.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
StampIndex::StampIndex(const Trajectory& trajectory)
{
  for (const auto& [stamp_s, pose] : trajectory) entries_.push_back({stamp_s, entries_.size()});
  std::stable_sort(entries_.begin(), entries_.end(),
                   [](const Entry& a, const Entry& b) { return a.stamp_s < b.stamp_s; });
}

std::optional<std::size_t> StampIndex::nearest(double stamp_s, double tolerance_s) const
{
  const auto firstNotBefore = [this](double t)
  {
    return std::lower_bound(entries_.begin(), entries_.end(), t,
                            [](const Entry& entry, double s) { return entry.stamp_s < s; });
  };
  const auto after = firstNotBefore(stamp_s);
  std::optional<Entry> best;
  const auto consider = [&](const Entry& entry)
  {
    const double away_s = std::abs(entry.stamp_s - stamp_s);
    const double bestAway_s = best ? std::abs(best->stamp_s - stamp_s) : tolerance_s;
    const bool isFirst = !best || entry.pose < best->pose;
    if (away_s < bestAway_s || (away_s == bestAway_s && isFirst)) best = entry;
  };
  if (after != entries_.begin()) consider(*firstNotBefore(std::prev(after)->stamp_s));
  if (after != entries_.end()) consider(*after);
  if (!best) return std::nullopt;
  return best->pose;
}
}  // namespace psmks
