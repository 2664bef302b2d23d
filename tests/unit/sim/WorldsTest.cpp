/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/sim/WorldIndex.h>
#include <psmks/sim/Worlds.h>

#include <cmath>
#include <set>
#include <stdexcept>

namespace psmks
{
namespace
{
constexpr unsigned kSeeds = 20;
constexpr double kAnyClearance_m = 100;

struct Counts
{
  std::string name;
  std::size_t walls, points;
};

double length_m(const Route& route)
{
  double sum_m = 0;
  for (std::size_t i = 1; i < route.size(); ++i) sum_m += (route[i] - route[i - 1]).norm();
  return sum_m;
}

/** Sum of all changes of direction, in turns of 360 degrees. */
double turns(const Route& route)
{
  double sum_rad = 0;
  for (std::size_t i = 2; i < route.size(); ++i)
  {
    const Eigen::Vector2d before = route[i - 1] - route[i - 2], after = route[i] - route[i - 1];
    const double cross = before.x() * after.y() - before.y() * after.x();
    sum_rad += std::abs(std::atan2(cross, before.dot(after)));
  }
  return sum_rad / (2 * kPi);
}

/** The smallest clearance along a route. */
double clearance_m(const WorldIndex& index, const Route& route)
{
  constexpr int kSteps = 200;
  double nearest_m = kAnyClearance_m;
  for (std::size_t i = 1; i < route.size(); ++i)
    for (int s = 0; s <= kSteps; ++s)
    {
      const Eigen::Vector2d place_m = route[i - 1] + (route[i] - route[i - 1]) * s / kSteps;
      nearest_m = std::min(nearest_m, index.clearance_m(place_m, nearest_m, 0));
    }
  return nearest_m;
}

class SiteByName : public testing::TestWithParam<Counts>
{
};

class RouteOfSite : public testing::TestWithParam<std::string>
{
};
}  // namespace

TEST_P(SiteByName, HasThePapersCountsForEverySeed)
{
  for (unsigned seed = 0; seed < kSeeds; ++seed)
  {
    const World world = makeSite(GetParam().name, seed).world;
    EXPECT_EQ(world.walls().size(), GetParam().walls) << "seed " << seed;
    EXPECT_EQ(world.points().size(), GetParam().points) << "seed " << seed;
  }
}

TEST_P(SiteByName, IsTheSameForTheSameSeedAndAnotherForAnother)
{
  const Site site = makeSite(GetParam().name, 3), same = makeSite(GetParam().name, 3),
             other = makeSite(GetParam().name, 4);
  bool differs = false;
  for (std::size_t w = 0; w < GetParam().walls; ++w)
  {
    EXPECT_EQ(site.world.walls()[w].a, same.world.walls()[w].a);
    EXPECT_EQ(site.world.walls()[w].b, same.world.walls()[w].b);
    differs = differs || site.world.walls()[w].a != other.world.walls()[w].a;
  }
  EXPECT_TRUE(differs);
  EXPECT_EQ(site.T_world_start.x_m, same.T_world_start.x_m);
  EXPECT_EQ(site.T_world_start.phi_rad, same.T_world_start.phi_rad);
}

TEST_P(SiteByName, TheRobotStartsWhereItFits)
{
  constexpr double kRobot_m = 0.38;
  for (unsigned seed = 0; seed < kSeeds; ++seed)
  {
    const Site site = makeSite(GetParam().name, seed);
    const Eigen::Vector2d start_m = site.T_world_start.translation();
    EXPECT_GT(site.world.clearance_m(start_m, kAnyClearance_m, 0), kRobot_m + 0.15)
        << "seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Paper, SiteByName,
                         testing::Values(Counts{"room", 32, 0}, Counts{"clutter", 130, 0},
                                         Counts{"curved", 130, 15114}, Counts{"corridors", 163, 0},
                                         Counts{"office", 139, 0}, Counts{"campus", 507, 0}),
                         [](const auto& counts) { return counts.param.name; });

TEST(Worlds, AnUnknownNameIsAnsweredWithTheKnownOnes)
{
  try
  {
    makeSite("moon", 1);
    FAIL() << "no exception";
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_STREQ(
        error.what(),
        "unknown world 'moon'; known are room, clutter, curved, corridors, office, campus, "
        "kilometres");
  }
}

TEST(Worlds, InTheOpenOnesTheRobotStartsWithAMetreAroundIt)
{
  for (const char* name : {"room", "clutter", "curved"})
    for (unsigned seed = 0; seed < kSeeds; ++seed)
    {
      const Site site = makeSite(name, seed);
      EXPECT_GE(site.world.clearance_m(site.T_world_start.translation(), kAnyClearance_m, 0), 0.99)
          << name << ", seed " << seed;
    }
}

TEST(Worlds, EveryPointOfTheCurvedOneLiesOnItsCircle)
{
  const World world = makeSite("curved", 1).world;
  ASSERT_EQ(world.circles().size(), 64U);
  std::set<int> circles;
  for (const World::Point& point : world.points())
  {
    ASSERT_NE(point.circle, World::Point::kNoCircle);
    const World::Circle& circle = world.circles()[static_cast<std::size_t>(point.circle)];
    EXPECT_NEAR((point.centre_m - circle.centre_m).norm(), circle.radius_m, 1e-9);
    circles.insert(point.circle);
  }
  EXPECT_EQ(circles.size(), 64U);
}

TEST_P(RouteOfSite, KeepsClearOfEverything)
{
  for (unsigned seed = 0; seed < kSeeds; ++seed)
  {
    const Site site = makeSite(GetParam(), seed);
    EXPECT_GE(clearance_m(WorldIndex(site.world), *site.route), 0.55) << "seed " << seed;
  }
}

TEST_P(RouteOfSite, BeginsWithTheRobotFacingItsFirstLeg)
{
  const Site site = makeSite(GetParam(), 1);
  EXPECT_EQ(site.T_world_start.translation(), site.route->front());
  const Eigen::Vector2d ahead = site.T_world_start.inverse() * (*site.route)[1];
  EXPECT_GT(ahead.x(), 0);
  EXPECT_NEAR(ahead.y(), 0, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(All, RouteOfSite, testing::Values("office", "campus", "kilometres"),
                         [](const auto& name) { return name.param; });

TEST(Worlds, TheKilometresLeadThereAndBackAndAreAsLongAsTheSeedSays)
{
  for (unsigned seed = 1; seed <= 10; ++seed)
  {
    const Route route = *makeSite("kilometres", seed).route;
    const double wanted_m = 2000.0 * (1 + (seed - 1) % 5);
    EXPECT_NEAR(length_m(route), wanted_m, 300) << "seed " << seed;
    for (std::size_t i = 0; i < route.size(); ++i)
      EXPECT_EQ(route[i], route[route.size() - 1 - i]) << "seed " << seed;
  }
}

TEST(Worlds, TheRoutesAreAsLongAndAsWindingAsThePapers)
{
  for (unsigned seed = 0; seed < kSeeds; ++seed)
  {
    const Route office = *makeSite("office", seed).route, campus = *makeSite("campus", seed).route;
    EXPECT_NEAR(length_m(office), 94, 3) << "seed " << seed;
    EXPECT_NEAR(turns(office), 8, 0.5) << "seed " << seed;
    EXPECT_NEAR(length_m(campus), 134, 3) << "seed " << seed;
    EXPECT_NEAR(turns(campus), 10, 0.5) << "seed " << seed;
  }
}
}  // namespace psmks
