/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/core/AnchoredLine.h>
#include <psmks/core/FastBearing.h>
#include <psmks/core/SegmentedScan.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace psmks
{
/** What a scan says of the world in every direction, prepared for fast look-ups.
 *
 * Between two neighbouring rays k and k+1 stand two surfaces: the line of ray k and the line of ray
 * k+1, each extended over the gap (paper, section 2.1: the line equation replaces interpolation,
 * and at the ends of succeeding segments both lines are candidates). A ray without a line stands
 * for the circle through its end point. */
class PolarSurface
{
 public:
  /** The surfaces on both sides of a bearing. Distances are n.p - d: negative in front of the
   * surface, seen from the scanner. */
  struct Cell
  {
    float nx[2], ny[2], d[2];
    int line[2];   //!< index into the lines it was built with, or -1
    bool known;    //!< both rays returned
    bool movable;  //!< both sides are a free-standing small object
  };

  /** @param lines of segments and patches
   *  @param lineOfRay index into lines of every ray, or -1
   *  @param movableRays one flag per ray, see findFreeStanding()
   *  Refers to none of them afterwards. Allocates only when the number of rays grows. */
  void build(const SegmentedScan& scan, const std::vector<AnchoredLine>& lines,
             const std::vector<int>& lineOfRay, const std::vector<std::uint8_t>& movableRays);

  int cells() const { return cells_; }
  const Cell& cell(int k) const { return storage_[static_cast<std::size_t>(k)]; }

  /** Index of the cell that holds the direction of a point; -1 outside the field of view. */
  int cellOf(float x, float y) const
  {
    float fromCentre_rad = fastBearing_rad(y, x) - centre_rad_;
    fromCentre_rad += fromCentre_rad < -kPiF ? 2 * kPiF : 0;
    fromCentre_rad -= fromCentre_rad >= kPiF ? 2 * kPiF : 0;
    const float index = fromCentre_rad * raysPerRadian_ + centreIndex_;
    const int inside = std::min(static_cast<int>(index), cells_ - 1);
    const int outside = closed_ ? cells_ - 1 : -1;
    return index >= 0 && index <= static_cast<float>(cells_) ? inside : outside;
  }

 private:
  static constexpr float kPiF = 3.14159265359f;

  std::vector<Cell> storage_;
  int cells_ = 0;
  bool closed_ = false;
  float centre_rad_ = 0, centreIndex_ = 0, raysPerRadian_ = 1;
};
}  // namespace psmks
