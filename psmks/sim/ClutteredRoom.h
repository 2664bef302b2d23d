/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/sim/World.h>
#include <psmks/sim/Worlds.h>

#include <optional>
#include <random>
#include <vector>

namespace psmks
{
/** A rectangular room about the origin with objects at random places. Any two of them are far
 * enough apart for a robot to pass between them. */
class ClutteredRoom
{
 public:
  /** Begins an empty room.
   *  @param gap_m least distance between the circles around two objects, and to the walls of
   *      the room */
  ClutteredRoom(const Eigen::Vector2d& size_m, double gap_m, unsigned seed);

  /** Adds boxes with sides between two lengths.
   *  @param maxTurn_rad largest angle of a box to the room, in either direction */
  void addBoxes(int count, double minSide_m, double maxSide_m, double maxTurn_rad);

  /** Adds chairs or tables: four square legs at the corners of a rectangle, at any angle. */
  void addFurniture(int count, const Eigen::Vector2d& size_m, double legSide_m);

  /** Adds straight walls at any angle. */
  void addFreeWalls(int count, double minLength_m, double maxLength_m);

  /** Reserves places for round objects. With arcs, every third of them is an open arc. Their points
   * are added by drawRoundObjects(). */
  void addRoundObjects(int count, double minRadius_m, double maxRadius_m, bool withArcs);

  /** Distributes a number of points over all round objects, with the same spacing on each of them.
   */
  void drawRoundObjects(int points);

  /** Whether everything found a place. If not, the layout has to be tried again with another seed.
   */
  bool isComplete() const { return complete_; }

  /** The room with a start pose at which the robot has space around itself. */
  Site site();

 private:
  struct Arc
  {
    World::Circle circle;
    double first_rad, last_rad;

    double length_m() const { return circle.radius_m * (last_rad - first_rad); }
  };

  std::optional<Eigen::Vector2d> findPlace(double radius_m, double gap_m);
  std::optional<Eigen::Vector2d> takePlace(double radius_m);
  double draw(double low, double high);

  Eigen::Vector2d size_m_;
  double gap_m_;
  std::mt19937_64 random_;
  World world_;
  std::vector<Disc> taken_;  //!< circles around the objects that are placed
  std::vector<Arc> arcs_;
  bool complete_ = true;
};

/** Makes the site of this name, see makeSite(). */
Site makeRoom(unsigned seed);
Site makeClutter(unsigned seed);
Site makeCurved(unsigned seed);

/** A floor full of chairs, tables and small boxes, whose walls are too far away for a scanner that
 * sees 4 m. The same seed gives the same world. */
Site makeLegs(unsigned seed);
}  // namespace psmks
