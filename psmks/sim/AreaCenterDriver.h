/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/sim/Driver.h>
#include <psmks/sim/RayFan.h>

#include <optional>
#include <random>

namespace psmks
{
struct AreaCenterOptions
{
  double gain = 0.48;      //!< speed in open space as a share of the robot's highest speed
  double fullReach_m = 5;  //!< ranges are cut to it, however far the scanner sees
};

/** Drives toward the centre of the free area that the scanner sees. This is the paper's roaming
 * driver, the Area Center method of Alvarez-Sanchez et al. 2010 (docs/simulation.md).
 * The drive never ends by itself.
 *
 * If the path to the centre is not free, the area is split at the obstacle, and the robot drives to
 * the centre of one side until it has passed the obstacle. If neither side can be reached, only the
 * near surroundings are taken into account, and at last the robot turns round. */
class AreaCenterDriver : public Driver
{
 public:
  /** @param seed of the random choices between the two sides of an obstacle */
  AreaCenterDriver(const AreaCenterOptions& options, const RobotOptions& robot, unsigned seed);

  WheelSpeeds drive(const DriverView& view) override;

 private:
  /** A place to drive to, and half the angle of the sector that it is the centre of. */
  struct Target
  {
    Eigen::Vector2d place_m;
    double halfAngle_rad;
  };

  /** One of the two sides on which an obstacle can be passed. */
  struct Side
  {
    double share;    //!< of all rays that lie on this side
    double reach_m;  //!< range to which its rays are cut
    double weight;   //!< in proportion to the probability of being chosen
    std::optional<Target> target;
  };

  void moveSplits(const Pose2& T_now_before);

  /** Turns the robot to the longest free lane if it has hardly moved for some time. */
  void watchForStandstill(const DriverView& view, const RayFan& fan);

  void turnBy(const DriverView& view, double angle_rad);
  std::optional<WheelSpeeds> turning(const DriverView& view);

  /** Forgets all splits and reduces the reach to the near surroundings. */
  void reduceReach();

  /** The centre of the area between the splits, or of one side of an obstacle, or else of the near
   * surroundings; nothing if none of them can be reached. */
  std::optional<Target> target(const RayFan& fan, double speed_mps);
  /** Chooses one side of an obstacle and remembers where the area was split. */
  std::optional<Target> split(const RayFan& sector, const RayFan& fan, double speed_mps);
  Side side(const RayFan& rays, const RayFan& fan, double speed_mps) const;
  std::optional<Target> centreOf(const RayFan& sector, const RayFan& fan, double speed_mps) const;
  bool isAccessible(const Eigen::Vector2d& centre_m, const RayFan& fan, double speed_mps) const;
  RayFan openSector(const RayFan& fan) const;

  WheelSpeeds toward(const Target& target) const;

  /** Slows the wheels down until they lead close to nothing; nothing if even the lowest speed is
   * not safe. */
  std::optional<WheelSpeeds> safe(WheelSpeeds speeds, const RayFan& fan) const;
  bool isSafe(const WheelSpeeds& speeds, const RayFan& fan) const;

  AreaCenterOptions options_;
  RobotOptions robot_;
  std::mt19937_64 random_;
  double reach_m_;

  // Obstacles at which the area was split, in the robot's frame: the robot passes to the left of
  // the first and to the right of the second.
  std::optional<Eigen::Vector2d> rightSplit_m_, leftSplit_m_;
  std::optional<double> turnTo_rad_;  // goal of a turn on the spot, heading of the odometry
  double reverseUntil_s_ = 0;

  Pose2 T_start_before_;   // odometry at the last control cycle
  Pose2 T_start_checked_;  // odometry at the last test for standstill
  double checked_s_ = 0;
};
}  // namespace psmks
