/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/sim/World.h>
#include <psmks/sim/Worlds.h>

#include <optional>
#include <random>
#include <vector>

namespace psmks
{
/** A rectangular room about the origin that fills with things in random places, every two of them
 * far enough apart for a robot to pass. */
class ClutteredRoom
{
 public:
  /** @param gap_m between the circles around any two things, and to the walls of the room */
  ClutteredRoom(const Eigen::Vector2d& size_m, double gap_m, unsigned seed);

  /** Adds boxes with sides between two lengths.
   *  @param maxTurn_rad of a box against the room, either way */
  void addBoxes(int count, double minSide_m, double maxSide_m, double maxTurn_rad);

  /** Adds straight walls at any angle. */
  void addFreeWalls(int count, double minLength_m, double maxLength_m);

  /** Makes room for round things; every third is an open arc where arcs are asked for. Their points
   * are added by drawRoundThings(). */
  void addRoundThings(int count, double minRadius_m, double maxRadius_m, bool withArcs);

  /** Shares so many points out among all round things, at the same pitch on each. */
  void drawRoundThings(int points);

  /** False when something found no place: the layout is to be tried with another seed. */
  bool isComplete() const { return complete_; }

  /** The room with a start where the robot has space around itself. */
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
  std::vector<Disc> taken_;  //!< circles around what has its place
  std::vector<Arc> arcs_;
  bool complete_ = true;
};

/** The sites of that kind, see makeSite(). */
Site makeRoom(unsigned seed);
Site makeClutter(unsigned seed);
Site makeCurved(unsigned seed);
}  // namespace psmks
