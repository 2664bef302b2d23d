/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/sim/Room.h>

namespace psmks
{
namespace
{
/** Interpolates linearly between two numbers. */
double between(double from, double to, double share) { return from + share * (to - from); }
}  // namespace

double Room::door_m() const
{
  constexpr double kToSideWall_m = 1.05;
  return plan_.doorAtBegin ? plan_.begin_m + kToSideWall_m : plan_.end_m - kToSideWall_m;
}

void Room::drawInto(World& world) const
{
  const Eigen::Vector2d nearBegin = frontage_.at(plan_.begin_m, plan_.near_m);
  const Eigen::Vector2d nearEnd = frontage_.at(plan_.end_m, plan_.near_m);
  const Eigen::Vector2d farBegin = frontage_.at(plan_.begin_m, plan_.far_m);
  const Eigen::Vector2d farEnd = frontage_.at(plan_.end_m, plan_.far_m);
  Frontage doorSide(nearEnd, nearBegin);
  doorSide.add({plan_.end_m - door_m(), kDoor_m, 0, false});
  doorSide.drawInto(world);
  world.addWall({nearBegin, farBegin});
  world.addWall({farBegin, farEnd});
  world.addWall({farEnd, nearEnd});
}

World::Wall Room::leaf() const
{
  constexpr double kThickness_m = 0.05;
  const double hinge_m = door_m() - inward() * (kDoor_m / 2 + kThickness_m);
  return {frontage_.at(hinge_m, plan_.near_m), frontage_.at(hinge_m, plan_.near_m + kDoor_m)};
}

Box Room::doorway() const
{
  constexpr double kMargin_m = 0.1;
  const Eigen::Vector2d centre_m = frontage_.at(door_m(), plan_.near_m + kDoor_m / 2);
  const double size_m = kDoor_m + 2 * kMargin_m;
  return {{centre_m.x(), centre_m.y(), frontage_.angle_rad()}, {size_m, size_m}};
}

Route Room::visit(double toMiddle_m) const
{
  constexpr double kLoop_m = 1.6, kToDoorSide_m = 0.95;
  const double front_m = plan_.near_m + kToDoorSide_m, back_m = front_m + kLoop_m;
  const double door = door_m(), aside_m = door + inward() * kLoop_m;
  return {frontage_.at(door, -toMiddle_m), frontage_.at(door, back_m),
          frontage_.at(aside_m, back_m),   frontage_.at(aside_m, front_m),
          frontage_.at(door, front_m),     frontage_.at(door, -toMiddle_m)};
}

Box Room::against(int side, const Eigen::Vector2d& size_m, double along) const
{
  constexpr double kGap_m = 0.02;  // between a wall and the furniture along it
  const double halfWidth_m = size_m.x() / 2 + kGap_m, halfDepth_m = size_m.y() / 2 + kGap_m;
  Eigen::Vector2d centre_m;
  if (side == 0)
    centre_m = frontage_.at(between(plan_.begin_m + halfWidth_m, plan_.end_m - halfWidth_m, along),
                            plan_.far_m - halfDepth_m);
  else
    centre_m = frontage_.at(side == 1 ? plan_.begin_m + halfDepth_m : plan_.end_m - halfDepth_m,
                            between(plan_.near_m + halfWidth_m, plan_.far_m - halfWidth_m, along));
  const double turn_rad = side == 0 ? 0 : kPi / 2;
  return {{centre_m.x(), centre_m.y(), wrapAngle(frontage_.angle_rad() + turn_rad)}, size_m};
}

Box Room::inTheOpen(const Eigen::Vector2d& share, const Eigen::Vector2d& size_m,
                    double phi_rad) const
{
  const double reach_m = size_m.norm() / 2;
  const Eigen::Vector2d centre_m =
      frontage_.at(between(plan_.begin_m + reach_m, plan_.end_m - reach_m, share.x()),
                   between(plan_.near_m + reach_m, plan_.far_m - reach_m, share.y()));
  return {{centre_m.x(), centre_m.y(), phi_rad}, size_m};
}
}  // namespace psmks
