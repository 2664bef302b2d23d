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
  double gain = 0.48;      //!< of the speed: in open space the share of the robot's highest one
  double fullReach_m = 5;  //!< nothing beyond it counts, however far the scanner sees
};

/** Drives where the free space is: toward the centre of the area the scanner sees (the paper's
 * roaming driver, the Area Center method of Alvarez-Sanchez et al. 2010; docs/algorithm.md,
 * "Simulation"). Never ends.
 *
 * Where the way to the centre is not free, the area is split there, and one side of it is driven
 * to until the place of the split is left behind. Where neither side can be reached, the robot
 * looks at its surroundings only, and at last turns round. */
class AreaCenterDriver : public Driver
{
 public:
  /** @param seed of the choices between two ways */
  AreaCenterDriver(const AreaCenterOptions& options, const RobotOptions& robot, unsigned seed);

  WheelSpeeds drive(const DriverView& view) override;

 private:
  /** A place to drive to, and half the angle of the sector whose centre it is. */
  struct Target
  {
    Eigen::Vector2d place_m;
    double halfAngle_rad;
  };

  /** One of the two ways past the place of a split. */
  struct Side
  {
    double share;    //!< of all rays
    double reach_m;  //!< with which it is looked at
    double weight;   //!< likely as such
    std::optional<Target> target;
  };

  void moveSplits(const Pose2& T_now_before);

  /** Turns to the longest free lane where the robot has hardly moved for a while. */
  void watchForStandstill(const DriverView& view, const RayFan& fan);

  void turnBy(const DriverView& view, double angle_rad);
  std::optional<WheelSpeeds> turning(const DriverView& view);

  /** Forgets all splits and looks at what is near. */
  void beCautious();

  /** The centre of the open sector, or of one side of it, or at last of what is near. */
  std::optional<Target> target(const RayFan& fan, double speed_mps);
  /** Chooses a side and remembers the place of the split. */
  std::optional<Target> split(const RayFan& sector, const RayFan& fan, double speed_mps);
  Side side(const RayFan& rays, const RayFan& fan, double speed_mps) const;
  std::optional<Target> centreOf(const RayFan& sector, const RayFan& fan, double speed_mps) const;
  bool isAccessible(const Eigen::Vector2d& centre_m, const RayFan& fan, double speed_mps) const;
  RayFan openSector(const RayFan& fan) const;

  WheelSpeeds toward(const Target& target) const;

  /** Slowed down until it leads close to nothing; none where slow is not enough. */
  std::optional<WheelSpeeds> safe(WheelSpeeds speeds, const RayFan& fan) const;
  bool isSafe(const WheelSpeeds& speeds, const RayFan& fan) const;

  AreaCenterOptions options_;
  RobotOptions robot_;
  std::mt19937_64 random_;
  double reach_m_;

  // Places of earlier splits in the robot's frame: the way leads to the left of the one, to the
  // right of the other.
  std::optional<Eigen::Vector2d> rightSplit_m_, leftSplit_m_;
  std::optional<double> turnTo_rad_;  // heading by the odometry
  double reverseUntil_s_ = 0;

  Pose2 T_start_before_;   // by the odometry, at the last cycle
  Pose2 T_start_checked_;  // at the last look whether the robot moves on
  double checked_s_ = 0;
};
}  // namespace psmks
