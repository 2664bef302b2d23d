/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/segmentation/LineInformation.h>
#include <psmks/segmentation/SegmentedScan.h>

#include <vector>

namespace psmks
{
/** The rays of a cleaned scan as line filters go through them: column by column, in the order of
 * their positions.
 *
 * Position 0 is the first ray of an open scan, and the ray at the strongest break of a closed one,
 * so that no wall is cut by the seam. Every column is longer than there are rays by a block of
 * places that hold no valid ray, so that loops may go in whole blocks. */
struct RaySoA
{
  /** Rays that a filter takes at once. Unit: rays. Definition: width of the vectors in the code,
   * and what one vector register of 256 bits holds. */
  static constexpr int kBlock = 4;

  using Block = Eigen::Array<double, kBlock, 1>;
  using BlockView = Eigen::Map<const Block>;

  std::vector<double> cosine, sine;               //!< of the bearing
  std::vector<double> range_m;                    //!< 0 where invalid
  std::vector<double> inverseRange_1_m;           //!< 0 where invalid
  std::vector<LineInformation::Moments> moments;  //!< of the valid rays, weighed by their noise
  std::vector<int> mark;                          //!< the line a ray belongs to, or kNoSegment
  int rays = 0;
  int start = 0;     //!< ray index of position 0
  RangeNoise noise;  //!< of the ranges

  /** Everything but moments, in the order of the rays; the noise is that of the scan. */
  void load(const SegmentedScan& scan);

  /** Begins with another ray instead. */
  void startAt(const SegmentedScan& scan, int ray);

  void computeMoments();

  /** Ray index of a position. */
  int ray(int position) const
  {
    const int i = start + position;
    return i < rays ? i : i - rays;
  }

  bool valid(int position) const { return range_m[static_cast<std::size_t>(position)] > 0; }

  MeasuredRay measured(int position) const
  {
    const auto p = static_cast<std::size_t>(position);
    return {cosine[p], sine[p], range_m[p], inverseRange_1_m[p]};
  }

  static BlockView block(const std::vector<double>& column, int position)
  {
    return BlockView(column.data() + position);
  }
};
}  // namespace psmks
