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
 * The one place where bearings become ray indices and back. A grid is *closed* when its rays go
 * round the whole circle, so that the last ray is the neighbour of the first; otherwise it is
 * *open*. The directions are computed once and shared by copies: keep one grid per scanner. */
class BeamGrid
{
 public:
  /** An empty grid: no rays. */
  BeamGrid();

  /** @param increment_rad > 0
   *  @param count >= 0; count * increment_rad may exceed the circle by half an increment at most
   *  @throws std::invalid_argument naming the value that breaks these rules */
  BeamGrid(double firstBearing_rad, double increment_rad, int count);

  /** `count` rays from -fieldOfView/2 to +fieldOfView/2, both ends included; the rays of a full
   *  circle are count distinct bearings starting at -pi. */
  static BeamGrid centered(double fieldOfView_rad, int count);

  int count() const { return count_; }
  double firstBearing_rad() const { return first_rad_; }
  double increment_rad() const { return increment_rad_; }
  double fieldOfView_rad() const;
  bool closed() const { return closed_; }

  /** Bearing of ray i, not wrapped. */
  double bearing_rad(int i) const { return first_rad_ + increment_rad_ * i; }

  /** Unit vector along ray i. */
  Eigen::Vector2d direction(int i) const { return {cosines()[i], sines()[i]}; }
  const double* cosines() const { return directions_->cosine.data(); }
  const double* sines() const { return directions_->sine.data(); }

  /** Fractional index of a bearing: ray i has index i. An open grid answers in
   *  [(count-1)/2 - pi/increment, (count-1)/2 + pi/increment), so that bearings outside the field
   * of view fall below 0 or above count-1; a closed grid answers in [-0.5, count-0.5). */
  double index(double bearing_rad) const;

  /** Neighbour of ray i, `step` rays on: wraps on a closed grid; -1 beyond the ends of an open one.
   */
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
