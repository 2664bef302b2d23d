/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/sim/Furniture.h>

#include <algorithm>

namespace psmks
{
namespace
{
/** Points along a route at a fixed spacing. */
Route sampled(const Route& route)
{
  constexpr double kPitch_m = 0.05;
  Route points;
  for (std::size_t i = 1; i < route.size(); ++i)
  {
    const Eigen::Vector2d leg = route[i] - route[i - 1];
    const int steps = static_cast<int>(std::ceil(leg.norm() / kPitch_m));
    for (int s = 0; s <= steps; ++s) points.push_back(route[i - 1] + leg * s / std::max(1, steps));
  }
  return points;
}
}  // namespace

Furniture::Furniture(const std::vector<Room>& rooms, const Route& route, std::mt19937_64& random)
    : rooms_(rooms), route_(sampled(route)), random_(random)
{
  for (const Room& room : rooms) avoid(room.doorway());
}

std::optional<std::vector<Box>> Furniture::place(int pieces)
{
  constexpr double kShareAlongWalls = 0.6;
  constexpr double kGapAlongWalls_m = 0.05, kGapInTheOpen_m = 0.3;
  constexpr int kTriesPerPiece = 2000;
  std::vector<Box> placed;
  std::size_t room = 0;
  for (int tries = pieces * kTriesPerPiece; tries > 0; --tries)
  {
    if (static_cast<int>(placed.size()) == pieces) return placed;
    const bool alongWall = static_cast<double>(placed.size()) < kShareAlongWalls * pieces;
    const Room& here = rooms_[room++ % rooms_.size()];
    const Box box = alongWall ? drawAlongWall(here) : drawInTheOpen(here);
    if (!fits(box, alongWall ? kGapAlongWalls_m : kGapInTheOpen_m)) continue;
    placed.push_back(box);
    avoid(box);
  }
  return std::nullopt;
}

Box Furniture::drawAlongWall(const Room& room)
{
  constexpr int kSides = 3;
  const double width_m = draw(0.8, 1.8), depth_m = draw(0.35, 0.75);
  const int side = static_cast<int>(random_() % kSides);
  return room.against(side, {width_m, depth_m}, draw(0, 1));
}

/** Chooses a chair or a bin, or a table parallel to the walls. */
Box Furniture::drawInTheOpen(const Room& room)
{
  const double alongShare = draw(0, 1), intoShare = draw(0, 1);
  const bool isTable = random_() % 2 == 0;
  if (isTable)
  {
    const double length_m = draw(0.8, 1.6), width_m = draw(0.6, 0.9);
    return room.inTheOpen({alongShare, intoShare}, {length_m, width_m}, 0);
  }
  const double side_m = draw(0.35, 0.5);
  return room.inTheOpen({alongShare, intoShare}, {side_m, side_m}, draw(-kPi, kPi));
}

bool Furniture::fits(const Box& box, double gap_m) const
{
  constexpr double kToRoute_m = 0.58;
  const auto isFar = [&box](const Eigen::Vector2d& point_m)
  { return box.distance_m(point_m) >= kToRoute_m; };
  const auto isApart = [&box, gap_m](const Box& other) { return box.isApart(other, gap_m); };
  return std::all_of(taken_.begin(), taken_.end(), isApart) &&
         std::all_of(route_.begin(), route_.end(), isFar);
}

double Furniture::draw(double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(random_);
}
}  // namespace psmks
