/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/sim/CellLists.h>
#include <psmks/sim/Surroundings.h>
#include <psmks/sim/UniformGrid.h>
#include <psmks/sim/World.h>

#include <vector>

namespace psmks
{
/** A world made fast to look up: its walls and points sorted into the cells of a uniform grid,
 * which a ray visits in order until a hit lies before the next cell. Moving objects are looked at
 * one by one. Answers exactly as World does.
 *
 * Immutable: may serve several threads. */
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
  CellLists<int> walls_;  //!< by number
  CellLists<World::Point> points_;
};
}  // namespace psmks
