/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/sim/Corridors.h>
#include <psmks/sim/Frontage.h>

#include <array>
#include <cmath>
#include <random>

namespace psmks
{
namespace
{
constexpr double kLength_m = 34, kHeight_m = 20, kCorridor_m = 1.5;
constexpr double kBlockLength_m = (kLength_m - 3 * kCorridor_m) / 2;
constexpr double kDoor_m = 1.0, kRecess_m = 0.25;
constexpr int kDoors = 37, kDoorsAjar = 3;

/** A part of a wall that may have a door. */
struct Slot
{
  std::size_t frontage;
  double begin_m, length_m;
};

double draw(std::mt19937_64& random, double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(random);
}

/** Adds the four sides of a rectangle, with the free space inside or outside. */
void addSides(std::vector<Frontage>& frontages, const Eigen::Vector2d& low_m,
              const Eigen::Vector2d& high_m, bool freeInside)
{
  const std::array<Eigen::Vector2d, 4> corners{low_m, Eigen::Vector2d(high_m.x(), low_m.y()),
                                               high_m, Eigen::Vector2d(low_m.x(), high_m.y())};
  for (std::size_t i = 0; i < 4; ++i)
  {
    const Eigen::Vector2d &a = corners[i], &b = corners[(i + 1) % 4];
    frontages.push_back(freeInside ? Frontage(a, b) : Frontage(b, a));
  }
}

std::vector<Frontage> corridorSides()
{
  std::vector<Frontage> frontages;
  addSides(frontages, {0, 0}, {kLength_m, kHeight_m}, true);
  for (const double left_m : {kCorridor_m, 2 * kCorridor_m + kBlockLength_m})
    addSides(frontages, {left_m, kCorridor_m}, {left_m + kBlockLength_m, kHeight_m - kCorridor_m},
             false);
  return frontages;
}

std::vector<Slot> doorSlots(const std::vector<Frontage>& frontages)
{
  constexpr double kSlot_m = 3;
  std::vector<Slot> slots;
  for (std::size_t f = 0; f < frontages.size(); ++f)
  {
    const int count = static_cast<int>(frontages[f].length_m() / kSlot_m);
    const double length_m = frontages[f].length_m() / count;
    for (int i = 0; i < count; ++i) slots.push_back({f, i * length_m, length_m});
  }
  return slots;
}

/** The leaf of a door that is ajar. It hangs at a back corner of the recess and stays within the
 * recess. */
World::Wall leafAjar(const Frontage& frontage, double centre_m, std::mt19937_64& random)
{
  constexpr double kLeaf_m = 0.95, kMinAngle_rad = 0.07, kMaxAngle_rad = 0.2;
  const double angle_rad = draw(random, kMinAngle_rad, kMaxAngle_rad);
  const double hinge_m = centre_m - kDoor_m / 2;
  return {frontage.at(hinge_m, kRecess_m), frontage.at(hinge_m + kLeaf_m * std::cos(angle_rad),
                                                       kRecess_m - kLeaf_m * std::sin(angle_rad))};
}
}  // namespace

//   +----- - ------- - ----------- - -----+  20 m     a door recess: -
//   | +-----------+   +------ - --------+ |
//   | |                                 | |
//   | |   block   |   |      block      | -
//   | +---- - ----+   +-----------------+ |
//   +------ - -------------- - ----- - ---+  0 to 34 m, all corridors 1.5 m wide
Site makeCorridors(unsigned seed)
{
  constexpr double kMinToSlotEnd_m = 0.2;
  std::mt19937_64 random(seed);
  std::vector<Frontage> frontages = corridorSides();
  std::vector<Slot> slots = doorSlots(frontages);
  std::vector<World::Wall> leaves;
  for (int door = 0; door < kDoors; ++door)
  {
    const auto chosen = slots.begin() + static_cast<std::ptrdiff_t>(random() % slots.size());
    const Slot slot = *chosen;
    slots.erase(chosen);
    const double margin_m = kDoor_m / 2 + kMinToSlotEnd_m;
    const double centre_m = slot.begin_m + draw(random, margin_m, slot.length_m - margin_m);
    Frontage& frontage = frontages[slot.frontage];
    frontage.add({centre_m, kDoor_m, kRecess_m});
    if (door < kDoorsAjar) leaves.push_back(leafAjar(frontage, centre_m, random));
  }
  World world;
  for (const Frontage& frontage : frontages) frontage.drawInto(world);
  for (const World::Wall& leaf : leaves) world.addWall(leaf);
  const double startAlong_m = draw(random, kCorridor_m, kLength_m - kCorridor_m);
  return {world, {startAlong_m, kCorridor_m / 2, 0}, std::nullopt};
}
}  // namespace psmks
