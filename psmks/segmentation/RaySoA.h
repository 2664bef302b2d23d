/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/segmentation/LineInformation.h>
#include <psmks/segmentation/SegmentedScan.h>

#include <vector>

namespace psmks
{
/** The rays of a cleaned scan as a structure of arrays, addressed by position.
 *
 * Positions count the rays of an open scan from the first one. In a closed scan position 0 is the
 * ray that strongestBreak() finds, so that no wall is cut by the seam of the grid. Every column has
 * one block of places more than there are rays. They hold invalid rays, so that loops may read
 * whole blocks. closeHoles() takes the rays out that a sparse scan has no return for. */
struct RaySoA
{
  /** Rays that a filter takes at once. Unit: rays. Definition: width of the vectors in the code,
   * and what one vector register of 256 bits holds. */
  static constexpr int kBlock = 4;

  using Block = Eigen::Array<double, kBlock, 1>;
  using BlockView = Eigen::Map<const Block>;

  std::vector<double> cosine, sine;               //!< of the bearings
  std::vector<double> range_m;                    //!< 0 where invalid
  std::vector<double> inverseRange_1_m;           //!< 0 where invalid
  std::vector<LineInformation::Moments> moments;  //!< weighted by the noise; 0 where invalid
  std::vector<int> mark;                          //!< index of a ray's line, or kNoSegment
  std::vector<int> rayOf;                         //!< index on the grid
  int rays = 0;                                   //!< positions
  RangeNoise noise;                               //!< of the ranges

  /** Fills all columns but the moments, with position 0 at the first ray of the scan. The noise
   * becomes that of the scan, all marks kNoSegment. */
  void load(const SegmentedScan& scan);

  /** Fills the same columns with position 0 at another ray. The noise stays as it is. */
  void startAt(const SegmentedScan& scan, int ray);

  /** Fills the moments from the other columns and the noise. */
  void computeMoments();

  /** Takes invalid rays out: all of a run of at most `longest`, all but a block of a longer one,
   * which is enough to end a line (LineGrowing).
   * Follows startAt(), and the moments are computed after it. */
  void closeHoles(int longest);

  /** Index on the grid of the ray at a position. */
  int ray(int position) const { return rayOf[static_cast<std::size_t>(position)]; }

  bool valid(int position) const { return range_m[static_cast<std::size_t>(position)] > 0; }

  MeasuredRay measured(int position) const
  {
    const auto p = static_cast<std::size_t>(position);
    return {cosine[p], sine[p], range_m[p], inverseRange_1_m[p]};
  }

  /** kBlock entries of a column, from a position on. */
  static BlockView block(const std::vector<double>& column, int position)
  {
    return BlockView(column.data() + position);
  }

 private:
  void move(std::size_t from, std::size_t to);
  void endAt(std::size_t position);
};
}  // namespace psmks
