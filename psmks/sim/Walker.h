/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/sim/Surroundings.h>

#include <Eigen/Core>
#include <random>
#include <vector>

namespace psmks
{
/** Whether a disc of the given radius can move straight from one place to another without touching
 * anything. It is tested every 10 cm, at time 0. */
bool isPathFree(const Surroundings& surroundings, const Eigen::Vector2d& from_m,
                const Eigen::Vector2d& to_m, double radius_m);

struct WalkerOptions
{
  double clearance_m = 0.35;  //!< least distance from the centre of the walker to any object
  double shortestWay_m = 1, longestWay_m = 8;
};

/** A person who walks through free space along straight lines of random direction and length. All
 * places that the walker reaches can be reached on foot from the first one. */
class Walker
{
 public:
  /** @param place_m where the walk begins; there must be enough free space around it */
  Walker(const Surroundings& surroundings, const Eigen::Vector2d& place_m,
         const WalkerOptions& options, std::mt19937_64& random)
      : surroundings_(surroundings), options_(options), random_(random), path_m_{place_m}
  {
  }

  /** Walks one more straight line.
   *  @return false if none was found */
  bool walkOn();

  /** Walks this many straight lines.
   *  @return false if one of them was not found */
  bool walkOn(int ways);

  const Eigen::Vector2d& place_m() const { return path_m_.back(); }

  /** The last points at which the walker changed direction.
   *  @param points at most one more than the lines walked */
  std::vector<Eigen::Vector2d> lastPoints_m(int points) const
  {
    return {path_m_.end() - points, path_m_.end()};
  }

 private:
  const Surroundings& surroundings_;
  WalkerOptions options_;
  std::mt19937_64& random_;
  std::vector<Eigen::Vector2d> path_m_;
};
}  // namespace psmks
