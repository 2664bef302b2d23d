/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/sim/PairSets.h>
#include <psmks/sim/Walker.h>
#include <psmks/slam/Overlap.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace psmks
{
namespace
{
constexpr int kWorlds = 6;  // number of worlds of a set

double draw(std::mt19937_64& random, double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(random);
}

/** The random engine of one pair for one purpose. */
std::mt19937_64 engine(unsigned seed, int pair, unsigned purpose)
{
  std::seed_seq sequence{seed, static_cast<unsigned>(pair), purpose};
  return std::mt19937_64(sequence);
}

Pose2 drawMotion(const PairFamily& family, std::mt19937_64& random)
{
  const double distance_m = draw(random, 0, family.maxTranslation_m);
  const double direction_rad = draw(random, -kPi, kPi);
  const double rotation_rad = draw(random, -family.maxRotation_rad, family.maxRotation_rad);
  return {distance_m * std::cos(direction_rad), distance_m * std::sin(direction_rad), rotation_rad};
}

Pose2 drawOdometry(const Pose2& T_ref_cur, std::mt19937_64& random)
{
  std::normal_distribution<double> share(0, kOdometryNoise);
  const double distance_m = T_ref_cur.translation().norm();
  const double x_m = T_ref_cur.x_m + distance_m * share(random);
  const double y_m = T_ref_cur.y_m + distance_m * share(random);
  return {x_m, y_m, T_ref_cur.phi_rad * (1 + share(random))};
}

PlanarVelocity drawVelocity(const PlanarVelocity& fastest, std::mt19937_64& random)
{
  if (fastest.isZero()) return {};
  const double x = draw(random, -1, 1), y = draw(random, -1, 1), phi = draw(random, -1, 1);
  return {x * fastest.x_m_s, y * fastest.y_m_s, phi * fastest.phi_rad_s};
}

PlanarVelocity drawOdometry(const PlanarVelocity& velocity, std::mt19937_64& random)
{
  if (velocity.isZero()) return {};
  std::normal_distribution<double> share(0, kOdometryNoise);
  const double speed_m_s = std::hypot(velocity.x_m_s, velocity.y_m_s);
  const double x_m_s = velocity.x_m_s + speed_m_s * share(random);
  const double y_m_s = velocity.y_m_s + speed_m_s * share(random);
  return {x_m_s, y_m_s, velocity.phi_rad_s * (1 + share(random))};
}

/** The pose after a time, in the axes of the start. */
Pose2 motionIn(double time_s, const PlanarVelocity& velocity)
{
  return {time_s * velocity.x_m_s, time_s * velocity.y_m_s, time_s * velocity.phi_rad_s};
}

/** Makes the pairs of a set one by one. */
class PairMaker
{
 public:
  PairMaker(const PairFamily& family, unsigned seed, const std::vector<Pose2>& starts,
            const std::vector<WorldIndex>& worlds)
      : family_(family), seed_(seed), starts_(starts), worlds_(worlds)
  {
  }

  SimulatedPair make(int id) const
  {
    constexpr unsigned kOfPlaces = 1, kOfNoise = 2, kOfOdometry = 3;
    std::mt19937_64 places = engine(seed_, id, kOfPlaces), noise = engine(seed_, id, kOfNoise);
    std::mt19937_64 odometry = engine(seed_, id, kOfOdometry);
    SimulatedPair pair;
    pair.id = id;
    pair.world = static_cast<std::size_t>(id) % worlds_.size();
    do
      while (!place(pair, places)) continue;
    while (!scan(pair, noise));
    pair.T_ref_cur_odometry = drawOdometry(pair.T_ref_cur_true, odometry);
    pair.refVelocityOdometry = drawOdometry(pair.refVelocity, odometry);
    pair.curVelocityOdometry = drawOdometry(pair.curVelocity, odometry);
    return pair;
  }

 private:
  const WorldIndex& world(const SimulatedPair& pair) const { return worlds_[pair.world]; }

  /** Chooses the poses of the sensor and the people of a pair.
   *  @return false if the chosen place does not suit a pair */
  bool place(SimulatedPair& pair, std::mt19937_64& random) const
  {
    /** Enough straight walks to reach every room from the middle of a floor. */
    constexpr int kStrollWays = 40;
    WalkerOptions robot;
    robot.clearance_m = kSensorClearance_m;
    Walker walker(world(pair), starts_[pair.world].translation(), robot, random);
    if (!walker.walkOn(kStrollWays)) return false;
    pair.T_world_ref = {walker.place_m().x(), walker.place_m().y(), draw(random, -kPi, kPi)};
    pair.T_ref_cur_true = drawMotion(family_, random);
    pair.refVelocity = drawVelocity(family_.fastest, random);
    pair.curVelocity = drawVelocity(family_.fastest, random);
    if (!isPathFree(world(pair), pair.T_world_ref.translation(), pair.T_world_cur().translation(),
                    kSensorClearance_m))
      return false;
    return placePeople(pair, random);
  }

  bool placePeople(SimulatedPair& pair, std::mt19937_64& random) const
  {
    constexpr int kTriesPerPerson = 20;
    pair.people.clear();
    for (int i = 0; i < family_.people * kTriesPerPerson; ++i)
    {
      if (static_cast<int>(pair.people.size()) == family_.people) break;
      const auto found = person(pair, random);
      if (found) pair.people.push_back(*found);
    }
    return static_cast<int>(pair.people.size()) == family_.people;
  }

  /** A person in full view of the reference, who then walks a step or two. */
  std::optional<MovingObject> person(const SimulatedPair& pair, std::mt19937_64& random) const
  {
    constexpr double kToSensor_m = 0.6;
    const Eigen::Vector2d atRef_m = pair.T_world_ref.translation();
    const Eigen::Vector2d atCur_m = pair.T_world_cur().translation();
    Walker fromSensor(world(pair), atRef_m, {MovingObject{}.radius_m, 1, 5}, random);
    if (!fromSensor.walkOn()) return std::nullopt;
    Walker onward(world(pair), fromSensor.place_m(), {MovingObject{}.radius_m, 0.3, 1.2}, random);
    if (!onward.walkOn() || (onward.place_m() - atCur_m).norm() < kToSensor_m) return std::nullopt;
    MovingObject person;
    person.path_m = onward.lastPoints_m(2);
    person.speed_mps = (person.path_m[1] - person.path_m[0]).norm() / kBetweenScans_s;
    return person;
  }

  /** Casts both scans.
   *  @return false if they do not overlap enough */
  bool scan(SimulatedPair& pair, std::mt19937_64& noise) const
  {
    pair.reference = cast(pair, pair.T_world_ref, pair.refVelocity, 0, noise);
    pair.current = cast(pair, pair.T_world_cur(), pair.curVelocity, kBetweenScans_s, noise);
    return overlap(pair.reference.scan, pair.current.scan, pair.T_ref_cur_true) >= kLeastOverlap;
  }

  SimulatedScan cast(const SimulatedPair& pair, const Pose2& T_world_middle,
                     const PlanarVelocity& velocity, double time_s, std::mt19937_64& noise) const
  {
    const auto T_world_sensor = [&](double sinceFirstRay_s)
    {
      const double sinceMiddle_s = sinceFirstRay_s - family_.laser.duration_s() / 2;
      return T_world_middle * motionIn(sinceMiddle_s, velocity);
    };
    if (pair.people.empty())
      return castScan(world(pair), T_world_sensor, time_s, family_.laser, noise);
    World worldWithPeople = world(pair).world();
    for (const MovingObject& person : pair.people) worldWithPeople.addMovingObject(person);
    return castScan(WorldIndex(std::move(worldWithPeople)), T_world_sensor, time_s, family_.laser,
                    noise);
  }

  const PairFamily& family_;
  unsigned seed_;
  const std::vector<Pose2>& starts_;
  const std::vector<WorldIndex>& worlds_;
};
}  // namespace

PairSet makePairSet(const PairFamily& family, unsigned seed, int count)
{
  PairSet set;
  set.family = family;
  std::vector<Pose2> starts;
  for (unsigned w = 0; w < kWorlds; ++w)
  {
    const Site site = family.makeSite(kWorlds * seed + w);
    set.worlds.emplace_back(site.world);
    starts.push_back(site.T_world_start);
  }
  const PairMaker maker(family, seed, starts, set.worlds);
  for (int id = 0; id < count; ++id) set.pairs.push_back(maker.make(id));
  return set;
}
}  // namespace psmks
