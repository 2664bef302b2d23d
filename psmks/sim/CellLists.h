/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <cstddef>
#include <vector>

namespace psmks
{
/** Which items lie in each cell of a grid, all lists in one flat array. */
class CellLists
{
 public:
  struct Entry
  {
    int cell, item;
  };

  struct List
  {
    const int *first, *last;
    const int* begin() const { return first; }
    const int* end() const { return last; }
  };

  CellLists() = default;
  CellLists(int cells, const std::vector<Entry>& entries);

  /** In the order of the entries. */
  List operator[](int cell) const
  {
    const auto c = static_cast<std::size_t>(cell);
    return {items_.data() + firstOfCell_[c], items_.data() + firstOfCell_[c + 1]};
  }

 private:
  std::vector<std::size_t> firstOfCell_;  //!< and the end of the last one
  std::vector<int> items_;
};
}  // namespace psmks
