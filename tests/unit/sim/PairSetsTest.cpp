/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/geometry/BeamTiming.h>
#include <psmks/sim/PairSets.h>
#include <psmks/sim/Walker.h>
#include <psmks/slam/Overlap.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <set>
#include <stdexcept>

namespace psmks
{
void PrintTo(const PairFamily& family, std::ostream* out) { *out << family.name; }

namespace
{
constexpr int kPairs = 12;
constexpr unsigned kSeed = 7;

PairSet setOf(const std::string& name, unsigned seed = kSeed, int count = kPairs)
{
  return makePairSet(pairFamily(name), seed, count);
}

bool isSame(const Pose2& a, const Pose2& b)
{
  return a.x_m == b.x_m && a.y_m == b.y_m && a.phi_rad == b.phi_rad;
}

bool isSame(const SimulatedPair& a, const SimulatedPair& b)
{
  return isSame(a.T_world_ref, b.T_world_ref) && isSame(a.T_ref_cur_true, b.T_ref_cur_true) &&
         isSame(a.T_ref_cur_odometry, b.T_ref_cur_odometry) &&
         a.reference.scan.range_m == b.reference.scan.range_m &&
         a.current.scan.range_m == b.current.scan.range_m;
}

double share(const SimulatedScan& scan, const std::function<bool(std::size_t ray)>& condition)
{
  int count = 0;
  for (std::size_t ray = 0; ray < scan.objectOfRay.size(); ++ray) count += condition(ray) ? 1 : 0;
  return static_cast<double>(count) / static_cast<double>(scan.objectOfRay.size());
}

double meanShare(const PairSet& set,
                 const std::function<bool(const SimulatedScan& scan, std::size_t ray)>& condition)
{
  double sum = 0;
  for (const SimulatedPair& pair : set.pairs)
    for (const SimulatedScan* scan : {&pair.reference, &pair.current})
      sum += share(*scan, [&](std::size_t ray) { return condition(*scan, ray); });
  return sum / (2.0 * static_cast<double>(set.pairs.size()));
}

class PairSetsOf : public testing::TestWithParam<PairFamily>
{
 protected:
  const PairSet set = makePairSet(GetParam(), kSeed, kPairs);
};

INSTANTIATE_TEST_SUITE_P(Families, PairSetsOf, testing::ValuesIn(pairFamilies()),
                         [](const auto& family) { return family.param.name; });
}  // namespace

TEST_P(PairSetsOf, TheSensorStandsInFreeSpaceAndCrossesNoWall)
{
  for (const SimulatedPair& pair : set.pairs)
  {
    const WorldIndex& world = set.worlds[pair.world];
    const Eigen::Vector2d ref_m = pair.T_world_ref.translation();
    const Eigen::Vector2d cur_m = pair.T_world_cur().translation();
    EXPECT_GE(world.clearance_m(ref_m, 1, 0), kSensorClearance_m);
    EXPECT_GE(world.clearance_m(cur_m, 1, 0), kSensorClearance_m);
    EXPECT_TRUE(isPathFree(world, ref_m, cur_m, kSensorClearance_m));
  }
}

TEST_P(PairSetsOf, ScansOverlapAndDisplacementsAreBounded)
{
  for (const SimulatedPair& pair : set.pairs)
  {
    EXPECT_GE(overlap(pair.reference.scan, pair.current.scan, pair.T_ref_cur_true), kLeastOverlap);
    EXPECT_LE(pair.T_ref_cur_true.translation().norm(), GetParam().maxTranslation_m);
    EXPECT_LE(std::abs(pair.T_ref_cur_true.phi_rad), GetParam().maxRotation_rad);
    EXPECT_EQ(pair.people.size(), static_cast<std::size_t>(GetParam().people));
  }
}

// Compares each range with the nearest object of the world along the ray from the true pose, which
// is found by testing all objects.
TEST_P(PairSetsOf, RangesAreThoseOfTheWorldAtTheTruth)
{
  for (const SimulatedPair& pair : set.pairs)
  {
    World world = set.worlds[pair.world].world();
    for (const MovingObject& person : pair.people) world.addMovingObject(person);
    for (int ray = 0; ray < pair.current.scan.grid.count(); ray += 20)
    {
      const auto i = static_cast<std::size_t>(ray);
      if (pair.current.scan.range_m[i] == 0) continue;
      const double time_s = sinceMiddle_s(pair.current.scan, ray);
      const Pose2 moved{time_s * pair.curVelocity.x_m_s, time_s * pair.curVelocity.y_m_s,
                        time_s * pair.curVelocity.phi_rad_s + pair.current.bearingOffset_rad};
      const Pose2 T_world_sensor = pair.T_world_cur() * moved;
      const Hit hit = world.cast(T_world_sensor.translation(),
                                 T_world_sensor.rotation() * pair.current.scan.grid.direction(ray),
                                 GetParam().laser.maxRange_m, kBetweenScans_s);
      EXPECT_NEAR(pair.current.scan.range_m[i] - pair.current.noise_m[i], hit.range_m, 1e-9);
      EXPECT_EQ(pair.current.objectOfRay[i], hit.object);
    }
  }
}

TEST_P(PairSetsOf, TheSeedDecidesEverything)
{
  const PairSet again = makePairSet(GetParam(), kSeed, kPairs / 2);
  const PairSet other = makePairSet(GetParam(), kSeed + 1, kPairs / 2);
  for (std::size_t p = 0; p < again.pairs.size(); ++p)
  {
    EXPECT_TRUE(isSame(again.pairs[p], set.pairs[p])) << "a shorter set begins the same";
    EXPECT_FALSE(isSame(other.pairs[p], set.pairs[p]));
  }
  for (const WorldIndex& world : set.worlds)
    for (const WorldIndex& otherWorld : other.worlds)
    {
      bool differs = world.world().walls().size() != otherWorld.world().walls().size();
      for (std::size_t w = 0; !differs && w < world.world().walls().size(); ++w)
        differs = world.world().walls()[w].a != otherWorld.world().walls()[w].a;
      EXPECT_TRUE(differs);
    }
}

TEST(PairSets, OdometryIsOffByFivePercentAnAxis)
{
  const PairSet set = setOf("L180_medium", 3, 300);
  double along2 = 0, rotation2 = 0;
  for (const SimulatedPair& pair : set.pairs)
  {
    const Pose2 &truth = pair.T_ref_cur_true, &odometry = pair.T_ref_cur_odometry;
    const double distance_m = truth.translation().norm();
    along2 += std::pow((odometry.x_m - truth.x_m) / distance_m, 2) / 300;
    rotation2 += std::pow(odometry.phi_rad / truth.phi_rad - 1, 2) / 300;
  }
  // The standard deviation of a sigma that is estimated from 300 draws is 4 %; 5 times that is
  // allowed.
  EXPECT_NEAR(std::sqrt(along2), kOdometryNoise, 0.2 * kOdometryNoise);
  EXPECT_NEAR(std::sqrt(rotation2), kOdometryNoise, 0.2 * kOdometryNoise);
}

TEST(PairSets, PairsComeFromAllWorlds)
{
  std::set<std::size_t> worlds;
  const PairSet set = setOf("L180_small");
  for (const SimulatedPair& pair : set.pairs) worlds.insert(pair.world);
  EXPECT_EQ(worlds.size(), set.worlds.size());
  EXPECT_GE(worlds.size(), 3U);
}

TEST(PairSets, FlawsShowInTheScans)
{
  const auto isLost = [](const SimulatedScan& scan, std::size_t ray)
  { return scan.scan.range_m[ray] == 0; };
  EXPECT_NEAR(meanShare(setOf("dropouts"), isLost), 0.10, 0.02);
  EXPECT_NEAR(meanShare(setOf("dropouts60"), isLost), 0.60, 0.02);
  EXPECT_NEAR(meanShare(setOf("every3"), isLost), 2 / 3.0, 0.01);

  const auto isRounded = [](const SimulatedScan& scan, std::size_t ray)
  { return std::abs(std::remainder(scan.scan.range_m[ray], 0.05)) < 1e-9; };
  EXPECT_EQ(meanShare(setOf("quantised"), isRounded), 1);

  const auto isBeyond2cm = [](const SimulatedScan& scan, std::size_t ray)
  { return std::abs(scan.noise_m[ray]) > 0.02; };
  EXPECT_NEAR(meanShare(setOf("L180_medium"), isBeyond2cm), 0.0455, 0.01);  // 2 sigma
  EXPECT_NEAR(meanShare(setOf("sigma3"), isBeyond2cm), 0.505, 0.03);        // 2/3 sigma

  const auto isMixed = [](const SimulatedScan& scan, std::size_t ray)
  { return std::abs(scan.noise_m[ray]) > 0.06; };
  EXPECT_EQ(meanShare(setOf("L180_medium"), isMixed), 0);
  EXPECT_GT(meanShare(setOf("mixed"), isMixed), 0.005);
}

TEST(PairSets, TheSensorMovesWhileItTakesInterleavedTurns)
{
  const PairSet set = setOf("interleaved");
  double fastest_rad_s = 0;
  for (const SimulatedPair& pair : set.pairs)
  {
    EXPECT_EQ(pair.current.scan.interleavedTurns, 2);
    EXPECT_LE(std::abs(pair.curVelocity.x_m_s), set.family.fastest.x_m_s);
    EXPECT_NE(pair.curVelocity.x_m_s, pair.refVelocity.x_m_s);
    const double measured = pair.curVelocityOdometry.phi_rad_s / pair.curVelocity.phi_rad_s;
    EXPECT_NEAR(measured, 1, 5 * kOdometryNoise);
    fastest_rad_s = std::max(fastest_rad_s, std::abs(pair.curVelocity.phi_rad_s));
  }
  EXPECT_GT(fastest_rad_s, set.family.fastest.phi_rad_s / 2);
}

TEST(PairSets, PeopleAreSeenAndMove)
{
  const PairSet set = setOf("L180dyn_medium");
  const auto isPerson = [&set](const SimulatedScan& scan, std::size_t ray)
  {
    for (const WorldIndex& world : set.worlds)
      if (scan.objectOfRay[ray] < world.world().objectOfMoving(0)) return false;
    return true;
  };
  EXPECT_GT(meanShare(set, isPerson), 0.03);
  for (const SimulatedPair& pair : set.pairs)
    for (const MovingObject& person : pair.people)
      EXPECT_GT((person.place_m(kBetweenScans_s) - person.place_m(0)).norm(), 0.29);
}

TEST(PairSets, ABareCorridorShowsOnlyItsTwoSides)
{
  std::set<int> seen;
  for (const SimulatedPair& pair : setOf("corridor").pairs)
    seen.insert(pair.current.objectOfRay.begin(), pair.current.objectOfRay.end());
  EXPECT_EQ(seen, (std::set<int>{Hit::kNothing, 0, 2})) << "1 and 3 are the ends";
}

TEST(PairFamilies, HaveDistinctNamesAndALineEach)
{
  std::set<std::string> names;
  for (const PairFamily& family : pairFamilies())
  {
    EXPECT_TRUE(names.insert(family.name).second) << family.name;
    EXPECT_GT(family.description.size(), 10U);
    EXPECT_EQ(family.description.find('\n'), std::string::npos);
  }
}

TEST(PairFamilies, AnUnknownNameIsRefusedWithTheKnownOnes)
{
  try
  {
    pairFamily("moon");
    FAIL();
  }
  catch (const std::invalid_argument& error)
  {
    const std::string text = error.what();
    EXPECT_NE(text.find("'moon'"), std::string::npos) << text;
    EXPECT_NE(text.find("L180_small, L180_medium"), std::string::npos) << text;
  }
}

TEST(PairFamilies, RoundingCountsAsNoise)
{
  EXPECT_DOUBLE_EQ(pairFamily("sigma3").rangeNoise().sigma_m, 0.03);
  EXPECT_NEAR(pairFamily("quantised").rangeNoise().sigma_m, 0.0175594, 1e-6);
  EXPECT_DOUBLE_EQ(pairFamily("rplidar").rangeNoise().sigmaPerMetre_m, 0.01);
}
}  // namespace psmks
