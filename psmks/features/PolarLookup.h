/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/AnchoredLine.h>
#include <psmks/geometry/FastBearing.h>
#include <psmks/segmentation/SegmentedScan.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace psmks
{
/** The surfaces that a scan saw in every direction, prepared for fast look-ups.
 *
 * Cell k lies between the neighbouring rays k and k+1. It has two surfaces, the line of ray k and
 * the line of ray k+1, each extended over the cell (paper, section 2.1: the line equation replaces
 * interpolation, and between two segments both lines are candidates). A ray without a line stands
 * for the circle about the scanner through its end point. */
class PolarLookup
{
 public:
  /** One surface: the line n.p = d. */
  struct Side
  {
    float nx, ny, d;  //!< unit normal, and distance from the scanner in m
    int line;         //!< index into the lines of build(), or -1

    /** Signed distance of a point, negative in front of the surface as seen from the scanner. */
    float distance_m(float x, float y) const { return nx * x + ny * y - d; }
  };

  /** Prepares the surfaces of a scan. The arguments are not referred to afterwards. Allocates only
   * where the scan has more rays or lines than any scan before.
   *  @param lines of the segments, short lines and surfels
   *  @param lineOfRay index into `lines` for every ray, or -1
   *  @param hasSurface one flag per ray: whether it has a return, or a line without one
   *  @param movableRays one flag per ray, see findMovableObjects() */
  void build(const SegmentedScan& scan, const std::vector<AnchoredLine>& lines,
             const std::vector<int>& lineOfRay, const std::vector<std::uint8_t>& hasSurface,
             const std::vector<std::uint8_t>& movableRays);

  /** Number of cells: one less than rays, on a closed grid as many. */
  int cells() const { return cells_; }

  /** The two surfaces of a cell: elements 0 and 1 of the array. */
  const Side* sides(int k) const { return sides_.data() + k; }

  /** Whether both rays of a cell have a surface. */
  bool known(int k) const { return flags_[static_cast<std::size_t>(k)] & kKnown; }

  /** Whether both rays of a cell are on movable objects. */
  bool movable(int k) const { return flags_[static_cast<std::size_t>(k)] & kMovable; }

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
  static Side roundSide(const SegmentedScan& scan, std::size_t ray);
  void flagCells(const std::vector<std::uint8_t>& hasSurface,
                 const std::vector<std::uint8_t>& movable);

  /** Half a circle. Unit: rad. Definition: pi as a float. */
  static constexpr float kPiF = 3.14159265359f;

  /** Flags of a cell, combined by bitwise or. Unit: bit. Definition: distinct bits. */
  static constexpr std::uint8_t kKnown = 1, kMovable = 2;

  std::vector<Side> sides_;          //!< one per ray, then the first one again
  std::vector<Side> lineSides_;      //!< one per line
  std::vector<std::uint8_t> flags_;  //!< kKnown and kMovable, one per cell
  int cells_ = 0;
  bool closed_ = false;
  float centre_rad_ = 0, centreIndex_ = 0, raysPerRadian_ = 1;
};
}  // namespace psmks
