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

  void moveSplits(const Pose2& T_now_before);
  void watchForStandstill(const DriverView& view, const RayFan& fan);
  void beCautious();
  void turnBy(const DriverView& view, double angle_rad);

  std::optional<WheelSpeeds> turning(const DriverView& view);
  std::optional<Target> target(const RayFan& fan, double speed_mps);
  std::optional<Target> centreOf(const RayFan& sector, const RayFan& fan, double speed_mps) const;
  std::optional<Target> split(const RayFan& sector, const Eigen::Vector2d& centre_m,
                              const RayFan& fan, double speed_mps);
  bool isAccessible(const Eigen::Vector2d& centre_m, const RayFan& fan, double speed_mps) const;
  WheelSpeeds toward(const Target& target) const;
  bool isSafe(const WheelSpeeds& speeds, const RayFan& fan) const;
  RayFan openSector(const RayFan& fan) const;

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
