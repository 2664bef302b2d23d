/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/sim/ClutteredRoom.h>

#include <cmath>
#include <functional>

namespace psmks
{
namespace
{
const Eigen::Vector2d kRoom_m(24, 18), kCurvedRoom_m(33, 25);

/** Tries layouts with the given seed and further ones until one is complete. */
Site firstComplete(unsigned seed, const std::function<ClutteredRoom(unsigned)>& layOut)
{
  constexpr unsigned kAttemptStride = 1000003;  // between the seeds of two attempts; large, so that
                                                // neighbouring seeds never share attempts
  for (unsigned attempt = 0;; ++attempt)
  {
    ClutteredRoom room = layOut(seed + attempt * kAttemptStride);
    if (room.isComplete()) return room.site();
  }
}

void addClutter(ClutteredRoom& room)
{
  room.addFreeWalls(2, 1.0, 2.2);
  room.addBoxes(31, 0.3, 0.8, kPi);
}
}  // namespace

ClutteredRoom::ClutteredRoom(const Eigen::Vector2d& size_m, double gap_m, unsigned seed)
    : size_m_(size_m), gap_m_(gap_m), random_(seed)
{
  world_.addBox({0, 0}, size_m);
}

void ClutteredRoom::addBoxes(int count, double minSide_m, double maxSide_m, double maxTurn_rad)
{
  for (int i = 0; i < count; ++i)
  {
    const double width_m = draw(minSide_m, maxSide_m), height_m = draw(minSide_m, maxSide_m);
    const auto centre_m = takePlace(std::hypot(width_m, height_m) / 2);
    if (centre_m) world_.addBox(*centre_m, {width_m, height_m}, draw(-maxTurn_rad, maxTurn_rad));
  }
}

void ClutteredRoom::addFreeWalls(int count, double minLength_m, double maxLength_m)
{
  for (int i = 0; i < count; ++i)
  {
    const double half_m = draw(minLength_m, maxLength_m) / 2, angle_rad = draw(-kPi, kPi);
    const Eigen::Vector2d toEnd =
        half_m * Eigen::Vector2d(std::cos(angle_rad), std::sin(angle_rad));
    const auto centre_m = takePlace(half_m);
    if (centre_m) world_.addWall({*centre_m - toEnd, *centre_m + toEnd});
  }
}

void ClutteredRoom::addFurniture(int count, const Eigen::Vector2d& size_m, double legSide_m)
{
  for (int i = 0; i < count; ++i)
  {
    const auto centre_m = takePlace(size_m.norm() / 2);
    if (!centre_m) continue;
    const Pose2 T_world_furniture{centre_m->x(), centre_m->y(), draw(-kPi, kPi)};
    for (const double x : {-0.5, 0.5})
      for (const double y : {-0.5, 0.5})
        world_.addBox(T_world_furniture * Eigen::Vector2d(x * size_m.x(), y * size_m.y()),
                      {legSide_m, legSide_m}, T_world_furniture.phi_rad);
  }
}

void ClutteredRoom::addRoundObjects(int count, double minRadius_m, double maxRadius_m,
                                    bool withArcs)
{
  constexpr double kMinArc_rad = kPi, kMaxArc_rad = kPi * 5 / 3;
  for (int i = 0; i < count; ++i)
  {
    const double radius_m = draw(minRadius_m, maxRadius_m), first_rad = draw(-kPi, kPi);
    const bool isArc = withArcs && i % 3 == 2;
    const double angle_rad = isArc ? draw(kMinArc_rad, kMaxArc_rad) : 2 * kPi;
    const auto centre_m = takePlace(radius_m + World::kPointRadius_m);
    if (centre_m) arcs_.push_back({{*centre_m, radius_m}, first_rad, first_rad + angle_rad});
  }
}

void ClutteredRoom::drawRoundObjects(int points)
{
  double total_m = 0, before_m = 0;
  for (const Arc& arc : arcs_) total_m += arc.length_m();
  int drawn = 0;
  for (const Arc& arc : arcs_)
  {
    before_m += arc.length_m();
    const int pointsUntilHere = static_cast<int>(std::lround(points * (before_m / total_m)));
    world_.addArc(arc.circle, arc.first_rad, arc.last_rad, pointsUntilHere - drawn);
    drawn = pointsUntilHere;
  }
}

Site ClutteredRoom::site()
{
  constexpr double kStartClearance_m = 1;
  std::optional<Eigen::Vector2d> start_m;
  while (!start_m) start_m = findPlace(0, kStartClearance_m);
  return {world_, {start_m->x(), start_m->y(), draw(-kPi, kPi)}, std::nullopt};
}

std::optional<Eigen::Vector2d> ClutteredRoom::takePlace(double radius_m)
{
  const auto centre_m = findPlace(radius_m, gap_m_);
  if (centre_m) taken_.push_back({*centre_m, radius_m});
  complete_ = complete_ && centre_m;
  return centre_m;
}

std::optional<Eigen::Vector2d> ClutteredRoom::findPlace(double radius_m, double gap_m)
{
  constexpr int kTries = 20000;
  const Eigen::Vector2d reach_m = size_m_ / 2 - Eigen::Vector2d::Constant(radius_m + gap_m);
  for (int i = 0; i < kTries; ++i)
  {
    const double x_m = draw(-reach_m.x(), reach_m.x()), y_m = draw(-reach_m.y(), reach_m.y());
    const Eigen::Vector2d centre_m(x_m, y_m);
    const auto isFar = [&](const Disc& disc)
    { return disc.distance_m(centre_m) >= radius_m + gap_m; };
    if (std::all_of(taken_.begin(), taken_.end(), isFar)) return centre_m;
  }
  return std::nullopt;
}

double ClutteredRoom::draw(double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(random_);
}

Site makeRoom(unsigned seed)
{
  const auto layOut = [](unsigned attempt)
  {
    ClutteredRoom room(kRoom_m, 1.6, attempt);
    room.addBoxes(7, 0.8, 2.0, 0);
    return room;
  };
  return firstComplete(seed, layOut);
}

Site makeClutter(unsigned seed)
{
  const auto layOut = [](unsigned attempt)
  {
    ClutteredRoom room(kRoom_m, 1.6, attempt);
    addClutter(room);
    return room;
  };
  return firstComplete(seed, layOut);
}

Site makeCurved(unsigned seed)
{
  constexpr int kPoints = 15114;
  const auto layOut = [](unsigned attempt)
  {
    ClutteredRoom room(kCurvedRoom_m, 1.4, attempt);
    addClutter(room);
    room.addRoundObjects(31, 0.2, 0.6, true);
    room.addRoundObjects(33, 0.02, 0.06, false);
    room.drawRoundObjects(kPoints);
    return room;
  };
  return firstComplete(seed, layOut);
}

Site makeLegs(unsigned seed)
{
  const auto layOut = [](unsigned attempt)
  {
    ClutteredRoom room({30, 30}, 0.5, attempt);
    room.addFurniture(60, {0.40, 0.40}, 0.03);
    room.addFurniture(25, {1.20, 0.70}, 0.05);
    room.addBoxes(40, 0.08, 0.35, kPi);
    return room;
  };
  return firstComplete(seed, layOut);
}
}  // namespace psmks
