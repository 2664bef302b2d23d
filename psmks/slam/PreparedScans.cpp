/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/slam/PreparedScans.h>

#include <algorithm>

namespace psmks
{
PreparedScans::PreparedScans(PairMatcher& matcher, std::size_t capacity)
    : matcher_(&matcher), capacity_(std::max<std::size_t>(capacity, 2))
{
}

std::shared_ptr<const PreparedScan> PreparedScans::find(std::size_t index, const Scan& scan)
{
  const auto kept = std::find_if(entries_.begin(), entries_.end(),
                                 [index](const Entry& entry) { return entry.index == index; });
  if (kept == entries_.end())
  {
    if (entries_.size() == capacity_) entries_.erase(entries_.begin());
    entries_.push_back(prepared(index, scan));
  }
  else
  {
    if (!isUpToDate(*kept)) *kept = prepared(index, scan);
    std::rotate(kept, kept + 1, entries_.end());
  }
  return entries_.back().scan;
}

bool PreparedScans::isUpToDate(const Entry& entry) const
{
  return !entry.scan->showsMoreNoise() || entry.noiseBelieved == scanner_.isBelieved();
}

PreparedScans::Entry PreparedScans::prepared(std::size_t index, const Scan& scan)
{
  Entry entry{index, matcher_->prepare(scan, scanner_), scanner_.isBelieved()};
  if (index >= firstUncounted_)
  {
    scanner_.add(entry.scan->showsMoreNoise());
    firstUncounted_ = index + 1;
  }
  return entry;
}
}  // namespace psmks
