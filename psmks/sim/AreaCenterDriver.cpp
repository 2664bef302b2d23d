/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/sim/AreaCenterDriver.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
// Constants of the source of the method.

/** Factor by which the reach grows in each control cycle, until it is the full reach. */
constexpr double kReachGrowth = 1.025;
/** Reach after no centre could be reached, as a share of the full reach. */
constexpr double kCautiousShare = 0.25;
/** A side of an obstacle is not driven to if it has a smaller share of all rays. */
constexpr double kLeastSideShare = 0.15;
/** A side of an obstacle that would be chosen with a smaller probability is never chosen. */
constexpr double kLeastProbability = 0.1;
/** Half the width of the strip that must be free on the path, in radii of the robot. */
constexpr double kWayWidth_radii = 1.1;
/** Length of this strip beyond the distance driven in kWayTime_s, in radii of the robot. */
constexpr double kWayLength_radii = 1.25;
constexpr double kWayTime_s = 1;
/** A smaller bearing of the target, or remainder of a turn, counts as straight ahead. */
constexpr double kStraight_rad = degToRad(2);
/** The inner wheel is slowed down by the cosine of this many times the bearing of the target. */
constexpr double kInnerWheelTurn = 1.8;
/** Speed of a turn on the spot and of driving backward, as a share of the highest speed. */
constexpr double kTurnShare = 0.1;
/** A turn on the spot is slowed down when less than this is left of it. */
constexpr double kSlowTurn_rad = degToRad(23);
/** Time of driving backward after a collision. */
constexpr double kReverse_s = 2;
/** Bearing of the outer rays that are used; obstacles beyond it have been passed. */
constexpr double kSectorEdge_rad = degToRad(90.5);

// Constants of our own, chosen so that the robot never touches anything and never stands for long.

/** Least reach with which a side of an obstacle is regarded. */
constexpr double kLeastReach_m = 0.3;
/** Two splits with a smaller angle between them are forgotten: nothing fits between them. */
constexpr double kLeastSplitAngle_rad = degToRad(10);
/** The motion of the next kLookAhead_s is tested for collisions, in steps of kLookStep_s. */
constexpr double kLookAhead_s = 1.2, kLookStep_s = 0.2;
/** Least share of the wanted speed that is tried if the full speed is not safe. */
constexpr double kLeastSpeedShare = 0.2;
/** Turn on the spot if no speed is safe. */
constexpr double kEvasiveTurn_rad = degToRad(40);
/** The robot stands still if it has moved less than kStandstill_m in kStandstill_s. */
constexpr double kStandstill_s = 12, kStandstill_m = 0.4;
/** Width of the lane that is searched after a standstill. */
constexpr double kLaneWidth_m = 0.9;

double bearing_rad(const Eigen::Vector2d& place_m) { return std::atan2(place_m.y(), place_m.x()); }
}  // namespace

AreaCenterDriver::AreaCenterDriver(const AreaCenterOptions& options, const RobotOptions& robot,
                                   unsigned seed)
    : options_(options), robot_(robot), random_(seed), reach_m_(options.fullReach_m)
{
}

WheelSpeeds AreaCenterDriver::drive(const DriverView& view)
{
  moveSplits(view.T_start_odometry.inverse() * T_start_before_);
  T_start_before_ = view.T_start_odometry;
  const RayFan fan(view.scan, view.T_robot_sensor, options_.fullReach_m);

  if (view.bumped) reverseUntil_s_ = view.time_s + kReverse_s;
  if (view.time_s < reverseUntil_s_)
    return {-kTurnShare * robot_.maxSpeed_mps, -kTurnShare * robot_.maxSpeed_mps};
  watchForStandstill(view, fan);
  if (const auto speeds = turning(view)) return *speeds;

  reach_m_ = std::min(kReachGrowth * reach_m_, options_.fullReach_m);
  const auto target = this->target(fan, (view.speeds.left_mps + view.speeds.right_mps) / 2);
  if (!target)
  {
    turnBy(view, kPi);
    return {};
  }
  if (const auto speeds = safe(toward(*target), fan)) return *speeds;
  const bool leftIsFreer =
      fan.sector(0, kSectorEdge_rad).meanRange_m() > fan.sector(-kSectorEdge_rad, 0).meanRange_m();
  turnBy(view, leftIsFreer ? kEvasiveTurn_rad : -kEvasiveTurn_rad);
  return {};
}

void AreaCenterDriver::moveSplits(const Pose2& T_now_before)
{
  for (auto* place : {&rightSplit_m_, &leftSplit_m_})
  {
    if (!*place) continue;
    *place = T_now_before * **place;
    if (std::abs(bearing_rad(**place)) > kSectorEdge_rad) place->reset();
  }
  const bool narrow =
      rightSplit_m_ && leftSplit_m_ &&
      bearing_rad(*leftSplit_m_) - bearing_rad(*rightSplit_m_) < kLeastSplitAngle_rad;
  if (!narrow) return;
  rightSplit_m_.reset();
  leftSplit_m_.reset();
}

void AreaCenterDriver::watchForStandstill(const DriverView& view, const RayFan& fan)
{
  if (view.time_s - checked_s_ < kStandstill_s) return;
  const double moved_m =
      (view.T_start_odometry.translation() - T_start_checked_.translation()).norm();
  T_start_checked_ = view.T_start_odometry;
  checked_s_ = view.time_s;
  if (moved_m > kStandstill_m) return;

  std::uniform_real_distribution<double> randomFactor(0.7, 1.3);  // so that it varies its choice
  double longest_m = 0, best_rad = 0;
  for (double bearing = -kPi / 2; bearing <= kPi / 2; bearing += degToRad(5))
  {
    const double lane_m = fan.lane_m(bearing, kLaneWidth_m) * randomFactor(random_);
    if (lane_m <= longest_m) continue;
    longest_m = lane_m;
    best_rad = bearing;
  }
  turnBy(view, best_rad);
}

void AreaCenterDriver::reduceReach()
{
  reach_m_ = kCautiousShare * options_.fullReach_m;
  rightSplit_m_.reset();
  leftSplit_m_.reset();
}

void AreaCenterDriver::turnBy(const DriverView& view, double angle_rad)
{
  turnTo_rad_ = wrapAngle(view.T_start_odometry.phi_rad + angle_rad);
}

std::optional<WheelSpeeds> AreaCenterDriver::turning(const DriverView& view)
{
  if (!turnTo_rad_) return std::nullopt;
  const double left_rad = wrapAngle(*turnTo_rad_ - view.T_start_odometry.phi_rad);
  if (std::abs(left_rad) < kStraight_rad)
  {
    turnTo_rad_.reset();
    reduceReach();
    return std::nullopt;
  }
  const double rim_mps =
      kTurnShare * robot_.maxSpeed_mps * std::clamp(left_rad / kSlowTurn_rad, -1.0, 1.0);
  return WheelSpeeds{-rim_mps, rim_mps};
}

RayFan AreaCenterDriver::openSector(const RayFan& fan) const
{
  return fan.sector(rightSplit_m_ ? bearing_rad(*rightSplit_m_) : -kSectorEdge_rad,
                    leftSplit_m_ ? bearing_rad(*leftSplit_m_) : kSectorEdge_rad);
}

std::optional<AreaCenterDriver::Target> AreaCenterDriver::target(const RayFan& fan,
                                                                 double speed_mps)
{
  const RayFan sector = openSector(fan).clipped(reach_m_);
  if (const auto found = centreOf(sector, fan, speed_mps)) return found;
  if (const auto found = split(sector, fan, speed_mps)) return found;
  reduceReach();
  return centreOf(fan.clipped(reach_m_), fan, speed_mps);
}

std::optional<AreaCenterDriver::Target> AreaCenterDriver::centreOf(const RayFan& sector,
                                                                   const RayFan& fan,
                                                                   double speed_mps) const
{
  if (sector.area_m2() <= 0) return std::nullopt;
  const Eigen::Vector2d centre_m = sector.areaCentre_m();
  if (!isAccessible(centre_m, fan, speed_mps)) return std::nullopt;
  return Target{centre_m, sector.halfAngle_rad()};
}

std::optional<AreaCenterDriver::Target> AreaCenterDriver::split(const RayFan& sector,
                                                                const RayFan& fan, double speed_mps)
{
  const Eigen::Vector2d centre_m = sector.areaCentre_m();
  const double at_rad = bearing_rad(centre_m);
  const Side right = side(sector.sector(-kSectorEdge_rad, at_rad), fan, speed_mps);
  const Side left = side(sector.sector(at_rad, kSectorEdge_rad), fan, speed_mps);
  const bool narrow = std::max(right.share, left.share) < kLeastSideShare;
  if (narrow || (!right.target && !left.target)) return std::nullopt;

  double leftLikely = left.weight / (left.weight + right.weight);
  if (leftLikely < kLeastProbability) leftLikely = 0;
  if (leftLikely > 1 - kLeastProbability) leftLikely = 1;
  if (!left.target) leftLikely = 0;
  if (!right.target) leftLikely = 1;
  const bool goLeft = std::bernoulli_distribution(leftLikely)(random_);
  (goLeft ? rightSplit_m_ : leftSplit_m_) = centre_m;
  reach_m_ = goLeft ? left.reach_m : right.reach_m;
  return goLeft ? left.target : right.target;
}

AreaCenterDriver::Side AreaCenterDriver::side(const RayFan& rays, const RayFan& fan,
                                              double speed_mps) const
{
  Side side;
  side.share = static_cast<double>(rays.count()) / fan.count();
  side.reach_m = std::max(kLeastReach_m, side.share * options_.fullReach_m);
  side.weight = rays.count() * rays.area_m2();
  side.target = centreOf(rays.clipped(side.reach_m), fan, speed_mps);
  return side;
}

// Tests the path to the centre: it begins along the heading and bends toward the centre half way.
bool AreaCenterDriver::isAccessible(const Eigen::Vector2d& centre_m, const RayFan& fan,
                                    double speed_mps) const
{
  const bool full = !rightSplit_m_ && !leftSplit_m_ && reach_m_ >= options_.fullReach_m;
  if (full && centre_m.norm() < 2 * robot_.radius_m) return false;
  if (fan.outlineDistance_m(centre_m) <= robot_.radius_m) return false;

  const double half_m = (kWayLength_radii * robot_.radius_m + kWayTime_s * speed_mps) / 2;
  const Eigen::Vector2d bend_m(half_m, 0);
  const Eigen::Vector2d end_m = bend_m + half_m * (centre_m - bend_m).normalized();
  const double needed_m = kWayWidth_radii * robot_.radius_m;
  return fan.pathClearance_m({0, 0}, bend_m) > needed_m &&
         fan.pathClearance_m(bend_m, end_m) > needed_m;
}

// The centroid of a free sector lies at a distance of 2/3 of its radius times sin(A) / A, with A
// half of its angle. The robot drives at full speed toward a centre at least that far away.
WheelSpeeds AreaCenterDriver::toward(const Target& target) const
{
  const double half_rad = target.halfAngle_rad;
  const double sinc = half_rad > 0 ? std::sin(half_rad) / half_rad : 1;
  const double free_m = 2.0 / 3 * options_.fullReach_m * sinc;
  const double full_mps = options_.gain * robot_.maxSpeed_mps * target.place_m.norm() / free_m;

  const double aside_rad = bearing_rad(target.place_m);
  if (std::abs(aside_rad) < kStraight_rad) return {full_mps, full_mps};
  const double outer_mps = full_mps * std::cos(aside_rad);
  const double inner_mps = outer_mps * std::cos(kInnerWheelTurn * aside_rad);
  if (aside_rad > 0) return {inner_mps, outer_mps};
  return {outer_mps, inner_mps};
}

std::optional<WheelSpeeds> AreaCenterDriver::safe(WheelSpeeds speeds, const RayFan& fan) const
{
  for (double share = 1; share >= kLeastSpeedShare; share /= 2)
  {
    if (isSafe(speeds, fan)) return speeds;
    speeds = {speeds.left_mps / 2, speeds.right_mps / 2};
  }
  return std::nullopt;
}

bool AreaCenterDriver::isSafe(const WheelSpeeds& speeds, const RayFan& fan) const
{
  const double needed_m = kWayWidth_radii * robot_.radius_m;
  const double now_m = fan.clearance_m({0, 0});
  for (double ahead_s = kLookStep_s; ahead_s <= kLookAhead_s; ahead_s += kLookStep_s)
  {
    const Eigen::Vector2d place_m = speeds.motion(robot_.track_m, ahead_s).translation();
    if (fan.clearance_m(place_m) < std::min(needed_m, now_m)) return false;
  }
  return true;
}

}  // namespace psmks
