/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/sim/People.h>
#include <psmks/sim/Walker.h>

#include <random>

namespace psmks
{
namespace
{
constexpr double kStartDistance_m = 2;  // least distance of people from the robot at its start
constexpr int kStrollWays = 12;         // straight walks of a person before those that are recorded
constexpr int kWays = 4;
constexpr int kTriesPerPerson = 100;

MovingObject person(std::vector<Eigen::Vector2d> path_m, std::mt19937_64& random)
{
  std::uniform_real_distribution<double> speed_mps(0.5, 1.2);
  MovingObject walking;
  walking.speed_mps = speed_mps(random);
  walking.path_m = std::move(path_m);
  return walking;
}
}  // namespace

std::vector<MovingObject> peopleAround(const Surroundings& surroundings,
                                       const Eigen::Vector2d& place_m, int count, unsigned seed)
{
  std::seed_seq ofPeople{seed, 3U};  // simulate() uses 1 and 2
  std::mt19937_64 random(ofPeople);
  std::vector<MovingObject> people;
  for (int i = 0; i < count * kTriesPerPerson && static_cast<int>(people.size()) < count; ++i)
  {
    Walker walker(surroundings, place_m, {}, random);
    if (!walker.walkOn(kStrollWays + kWays)) return people;
    auto path_m = walker.lastPoints_m(kWays + 1);
    if ((path_m.front() - place_m).norm() < kStartDistance_m) continue;
    people.push_back(person(std::move(path_m), random));
  }
  return people;
}
}  // namespace psmks
