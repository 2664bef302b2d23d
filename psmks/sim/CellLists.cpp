/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/sim/CellLists.h>

#include <numeric>

namespace psmks
{
CellLists::CellLists(int cells, const std::vector<Entry>& entries)
    : firstOfCell_(static_cast<std::size_t>(cells) + 1), items_(entries.size())
{
  for (const Entry& entry : entries) ++firstOfCell_[static_cast<std::size_t>(entry.cell) + 1];
  std::partial_sum(firstOfCell_.begin(), firstOfCell_.end(), firstOfCell_.begin());
  std::vector<std::size_t> next = firstOfCell_;
  for (const Entry& entry : entries)
    items_[next[static_cast<std::size_t>(entry.cell)]++] = entry.item;
}
}  // namespace psmks
