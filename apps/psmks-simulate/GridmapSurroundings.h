/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/mrpt/GridmapRanges.h>
#include <psmks/sim/World.h>

#include <vector>

namespace psmks
{
/** A grid map that one can drive in, with people. A hit names the cell; people count on behind the
 * last cell. */
class GridmapSurroundings : public Surroundings
{
 public:
  explicit GridmapSurroundings(GridmapRanges map) : map_(std::move(map)) {}

  void add(MovingObject person) { people_.addMovingObject(std::move(person)); }

  Hit cast(const Eigen::Vector2d& origin_m, const Eigen::Vector2d& direction, double maxRange_m,
           double time_s) const override;
  double clearance_m(const Eigen::Vector2d& point_m, double limit_m, double time_s) const override;

  /** What a picture shows: the outlines as points, and the people. */
  World drawn() const;

 private:
  GridmapRanges map_;
  World people_;
};
}  // namespace psmks
