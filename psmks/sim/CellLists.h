/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace psmks
{
/** The items that lie in each cell of a grid. All lists are kept in one array. */
template <typename Item>
class CellLists
{
 public:
  struct Entry
  {
    int cell;
    Item item;
  };

  struct List
  {
    const Item *first, *last;
    const Item* begin() const { return first; }
    const Item* end() const { return last; }
  };

  CellLists(int cells, const std::vector<Entry>& entries)
      : firstOfCell_(static_cast<std::size_t>(cells) + 1), items_(entries.size())
  {
    for (const Entry& entry : entries) ++firstOfCell_[static_cast<std::size_t>(entry.cell) + 1];
    std::partial_sum(firstOfCell_.begin(), firstOfCell_.end(), firstOfCell_.begin());
    std::vector<std::size_t> next = firstOfCell_;
    for (const Entry& entry : entries)
      items_[next[static_cast<std::size_t>(entry.cell)]++] = entry.item;
  }

  /** The items of a cell, in the order in which they were entered. */
  List operator[](int cell) const
  {
    const auto c = static_cast<std::size_t>(cell);
    return {items_.data() + firstOfCell_[c], items_.data() + firstOfCell_[c + 1]};
  }

 private:
  /** Index of the first item of each cell, then the number of all items. */
  std::vector<std::size_t> firstOfCell_;
  std::vector<Item> items_;
};
}  // namespace psmks
