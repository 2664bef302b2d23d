/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/sim/Surroundings.h>

#include <Eigen/Core>
#include <random>
#include <vector>

namespace psmks
{
/** Whether one can walk straight from one place to another with this distance to everything on the
 * way. Looked at every 10 cm, at time 0. */
bool isWayFree(const Surroundings& surroundings, const Eigen::Vector2d& from_m,
               const Eigen::Vector2d& to_m, double elbowRoom_m);

struct WalkerOptions
{
  double elbowRoom_m = 0.35;  //!< from the middle of the walker to anything
  double shortestWay_m = 1, longestWay_m = 8;
};

/** Someone who strolls through free space, one straight way after another, each of random direction
 * and length: wherever he comes can be walked to from where he began. */
class Walker
{
 public:
  /** @param place_m where he begins, with elbow room around */
  Walker(const Surroundings& surroundings, const Eigen::Vector2d& place_m,
         const WalkerOptions& options, std::mt19937_64& random)
      : surroundings_(surroundings), options_(options), random_(random), path_m_{place_m}
  {
  }

  /** One way further; false where none was found. */
  bool walkOn();

  /** So many ways further; false where one of them was not found. */
  bool walkOn(int ways);

  const Eigen::Vector2d& place_m() const { return path_m_.back(); }

  /** Where his last ways began and ended.
   *  @param points at most one more than he has walked ways */
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
