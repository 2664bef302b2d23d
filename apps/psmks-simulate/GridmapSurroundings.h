/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/mrpt/GridmapRanges.h>
#include <psmks/sim/World.h>

#include <vector>

namespace psmks
{
/** A grid map with people to drive in. The number of a hit is that of the cell; the numbers of
 * people follow that of the last cell. */
class GridmapSurroundings : public Surroundings
{
 public:
  explicit GridmapSurroundings(GridmapRanges map) : map_(std::move(map)) {}

  void add(MovingObject person) { people_.addMovingObject(std::move(person)); }

  Hit cast(const Eigen::Vector2d& origin_m, const Eigen::Vector2d& direction, double maxRange_m,
           double time_s) const override;
  double clearance_m(const Eigen::Vector2d& point_m, double limit_m, double time_s) const override;

  /** A world for a picture, with the outlines of the map as points and with the people. */
  World drawn() const;

 private:
  GridmapRanges map_;
  World people_;
};
}  // namespace psmks
