/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Angle.h>

#include <Eigen/Core>
#include <memory>
#include <vector>

namespace psmks
{
/** The bearings of a scanner's rays: evenly spaced, counter-clockwise, in the sensor frame.
 *
 * All conversions between bearings and indices of rays are made here. A grid is *closed* if its
 * rays go round the whole circle, so that the last ray is the neighbour of the first; otherwise it
 * is *open*. The directions of the rays are computed once and shared by copies of the grid, so a
 * program needs one grid for each scanner. */
class BeamGrid
{
 public:
  /** Makes an empty grid, which has no rays. */
  BeamGrid();

  /** Smallest angle between neighbouring rays. Definition: a fiftieth of the finest scanner, so
   * that no scan has more than 630,000 rays. */
  static constexpr double kLeastIncrement_rad = 1e-5;

  /** Largest first bearing, to either side. Definition: two turns. */
  static constexpr double kLargestBearing_rad = 4 * kPi;

  /** Makes a grid of `count` rays from the first bearing on.
   *  @param firstBearing_rad within kLargestBearing_rad of 0
   *  @param increment_rad angle between neighbouring rays, >= kLeastIncrement_rad
   *  @param count >= 0; count * increment_rad exceeds the circle by less than half an increment
   *  @throws std::invalid_argument if an argument breaks these rules; the text names its value */
  BeamGrid(double firstBearing_rad, double increment_rad, int count);

  /** Whether the constructor accepts these values. */
  static bool accepts(double firstBearing_rad, double increment_rad, int count);

  /** Makes a grid of `count` rays from -fieldOfView/2 to +fieldOfView/2, both ends included. If the
   * field of view is the full circle, both ends are the same direction: the rays then have `count`
   * distinct bearings from -pi on. */
  static BeamGrid centered(double fieldOfView_rad, int count);

  int count() const { return count_; }
  double firstBearing_rad() const { return first_rad_; }
  double increment_rad() const { return increment_rad_; }
  double fieldOfView_rad() const;
  bool closed() const { return closed_; }

  /** Bearing of ray i. It is not wrapped to (-pi, pi]. */
  double bearing_rad(int i) const { return first_rad_ + increment_rad_ * i; }

  /** Unit vector along ray i. */
  Eigen::Vector2d direction(int i) const { return {cosines()[i], sines()[i]}; }
  const double* cosines() const { return directions_->cosine.data(); }
  const double* sines() const { return directions_->sine.data(); }

  /** The index at a bearing as a fraction: at the bearing of ray i it is i. On an open grid it lies
   * in [(count-1)/2 - pi/increment, (count-1)/2 + pi/increment), so that bearings outside the field
   * of view are below 0 or above count-1. On a closed grid it lies in [-0.5, count-0.5). */
  double index(double bearing_rad) const;

  /** The index of the ray `step` rays after ray i, or -1 if an open grid has no such ray. A closed
   * grid always has one. */
  int neighbour(int i, int step) const;

  bool operator==(const BeamGrid& other) const;
  bool operator!=(const BeamGrid& other) const { return !(*this == other); }

 private:
  struct Directions
  {
    std::vector<double> cosine, sine;
  };

  double first_rad_ = 0;
  double increment_rad_ = 1;
  int count_ = 0;
  bool closed_ = false;
  std::shared_ptr<const Directions> directions_;
};
}  // namespace psmks
