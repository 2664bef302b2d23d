/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/features/ScanFeatures.h>

#include <array>
#include <cstdint>
#include <vector>

namespace psmks
{
/** What the end of a ray in each place about a scan says for a pose that puts it there, on a
 * raster, with an upper bound for every square of cells.
 *
 * Level 0 holds the evidence of each cell: that of the outcome (RayOutcome) of a ray that ends in
 * the middle of the cell, where what is within a cell and the tolerance of the ranges of a surface
 * is on it. Beyond the rectangle about the end points of the scan it is 0. At level h the value at
 * (i, j) is the highest evidence of the 2^h by 2^h cells from (i, j) on, so that a block of
 * translations of that size has one look-up per ray as its bound (Hess et al., 2016). */
class EvidenceGrid
{
 public:
  /** Levels of the grid: the last one bounds squares of 32 cells. Unit: levels. Definition:
   * squares of 3.2 m with the usual cells, of which a few cover the widest search. */
  static constexpr int kLevels = 6;

  /** Evidence of a ray on a surface; that of the other outcomes is in proportion. Unit: 1 / 24 of
   * it. Definition: the evidence of all outcomes is whole numbers of it, and fits into 8 bits. */
  static constexpr int kOnSurface = 24;

  /** Prepares the grid of a scan.
   *  @param reach_m how far beyond the end points of the scan places are asked for, in either axis
   *  @param rangeTolerance_m within which a point is on a surface */
  void build(const ScanFeatures& scan, double reach_m, double rangeTolerance_m);

  /** A rectangle about the scanner. */
  struct Extent
  {
    float left_m = 0, right_m = 0, bottom_m = 0, top_m = 0;
  };

  /** Reserves the memory of the largest grid, so that none allocates. */
  void reserve();

  double cell_m() const { return cell_m_; }

  /** Index of the cell of a place, or -1 where every place within the reach is unknown. */
  int indexOf(float x_m, float y_m) const
  {
    const float x = (x_m - originX_m_) * perMetre_, y = (y_m - originY_m_) * perMetre_;
    const auto first = static_cast<float>(reach_);
    const bool isInside = x >= first && y >= first && x < static_cast<float>(columns_ - margin_) &&
                          y < static_cast<float>(rows_ - margin_);
    return isInside ? static_cast<int>(y) * columns_ + static_cast<int>(x) : -1;
  }

  /** How far the index of a cell is from that of a cell by so many columns and rows beside it. */
  int offset(int columns, int rows) const { return rows * columns_ + columns; }

  /** The values of a level, by index. */
  const std::int8_t* level(int h) const { return levels_[static_cast<std::size_t>(h)].data(); }

 private:
  void layOut(const Extent& extent, double reach_m);
  void fillRow(const PolarLookup& surface, int row, float tolerance_m);
  void bound();

  double cell_m_ = 0;
  float perMetre_ = 0;
  float originX_m_ = 0, originY_m_ = 0;  //!< the corner of the first cell
  int columns_ = 0, rows_ = 0;
  int reach_ = 0;   //!< the reach in cells
  int margin_ = 0;  //!< cells at the far edges in which no ray of the guess ends
  std::array<std::vector<std::int8_t>, kLevels> levels_;
};
}  // namespace psmks
