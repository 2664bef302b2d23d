/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/UniformGrid.h>
#include <psmks/sim/CellLists.h>
#include <psmks/sim/Surroundings.h>
#include <psmks/sim/World.h>

#include <vector>

namespace psmks
{
/** An index of a world for fast ray casting. Walls and points are sorted into the cells of a
 * uniform grid, which a ray visits in order until it has a hit before the next cell. Moving objects
 * are tested one by one. The answers are exactly those of World.
 *
 * It is immutable and may serve several threads. */
class WorldIndex : public Surroundings
{
 public:
  static constexpr double kCell_m = 0.5;

  explicit WorldIndex(World world);

  const World& world() const { return world_; }

  Hit cast(const Eigen::Vector2d& origin_m, const Eigen::Vector2d& direction, double maxRange_m,
           double time_s) const override;
  double clearance_m(const Eigen::Vector2d& point_m, double limit_m, double time_s) const override;

 private:
  void castInCell(int cell, const Eigen::Vector2d& origin_m, const Eigen::Vector2d& direction,
                  Hit& nearest) const;
  double clearanceInCell_m(int cell, const Eigen::Vector2d& point_m) const;
  double clearanceInRing_m(int column, int row, int ring, const Eigen::Vector2d& point_m) const;

  World world_;
  UniformGrid grid_;
  CellLists<int> walls_;  //!< numbers of the walls in each cell
  CellLists<World::Point> points_;
};
}  // namespace psmks
