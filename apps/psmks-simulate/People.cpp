/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-simulate/People.h>
#include <psmks/core/Angle.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace psmks
{
namespace
{
constexpr double kElbowRoom_m = 0.35;  // from the middle of a person to anything
constexpr double kStride_m = 0.1;      // a way is looked at in such steps
constexpr double kShortestWay_m = 1, kLongestWay_m = 8;
constexpr double kStartDistance_m = 2;  // nobody stands closer to the robot when it starts
constexpr int kStrollWays = 12;         // before a person's own ways begin
constexpr int kWays = 4;
constexpr int kTries = 100;

/** Someone who looks for ways to walk. */
class Walker
{
 public:
  Walker(const Surroundings& surroundings, const Eigen::Vector2d& place_m, std::mt19937_64& random)
      : surroundings_(surroundings), random_(random), path_m_{place_m}
  {
  }

  /** One way further; false where none was found. */
  bool walkOn()
  {
    std::uniform_real_distribution<double> angle_rad(-kPi, kPi);
    std::uniform_real_distribution<double> length_m(kShortestWay_m, kLongestWay_m);
    for (int i = 0; i < kTries; ++i)
    {
      const double angle = angle_rad(random_);
      const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
      const double wayLength_m = length_m(random_);
      if (!isFree(direction, wayLength_m)) continue;
      path_m_.push_back(path_m_.back() + wayLength_m * direction);
      return true;
    }
    return false;
  }

  std::vector<Eigen::Vector2d> lastPoints_m(int points) const
  {
    return {path_m_.end() - points, path_m_.end()};
  }

 private:
  /** Discs of elbow room a stride apart cover the way but for slivers. */
  bool isFree(const Eigen::Vector2d& direction, double length_m) const
  {
    for (double way_m = kStride_m; way_m < length_m + kStride_m; way_m += kStride_m)
    {
      const Eigen::Vector2d point_m = path_m_.back() + std::min(way_m, length_m) * direction;
      if (surroundings_.clearance_m(point_m, kElbowRoom_m, 0) < kElbowRoom_m) return false;
    }
    return true;
  }

  const Surroundings& surroundings_;
  std::mt19937_64& random_;
  std::vector<Eigen::Vector2d> path_m_;
};

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
  std::seed_seq ofPeople{seed, 3U};  // 1 and 2 are those of simulate()
  std::mt19937_64 random(ofPeople);
  std::vector<MovingObject> people;
  for (int i = 0; i < count * kTries && static_cast<int>(people.size()) < count; ++i)
  {
    Walker walker(surroundings, place_m, random);
    bool walks = true;
    for (int way = 0; walks && way < kStrollWays + kWays; ++way) walks = walker.walkOn();
    if (!walks) return people;
    auto path_m = walker.lastPoints_m(kWays + 1);
    if ((path_m.front() - place_m).norm() < kStartDistance_m) continue;
    people.push_back(person(std::move(path_m), random));
  }
  return people;
}
}  // namespace psmks
