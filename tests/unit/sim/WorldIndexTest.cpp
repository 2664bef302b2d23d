/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/sim/WorldIndex.h>
#include <psmks/sim/Worlds.h>

#include <cmath>
#include <random>

namespace psmks
{
namespace
{
/** Random rays and places all over a site and around it. */
class Questions
{
 public:
  explicit Questions(unsigned seed) : random_(seed) {}

  Eigen::Vector2d place()
  {
    constexpr double kReach_m = 60;
    const double x_m = draw(-kReach_m, kReach_m);
    return {x_m, draw(-kReach_m, kReach_m)};
  }

  /** Any direction; every fourth one parallel to an axis. */
  Eigen::Vector2d direction()
  {
    const int choice = static_cast<int>(random_() % 16);
    if (choice < 2) return Eigen::Vector2d::Unit(choice);
    if (choice < 4) return -Eigen::Vector2d::Unit(choice - 2);
    const double angle_rad = draw(-kPi, kPi);
    return {std::cos(angle_rad), std::sin(angle_rad)};
  }

  double draw(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

 private:
  std::mt19937_64 random_;
};

void expectSameAnswers(const World& world, unsigned seed)
{
  SCOPED_TRACE("seed " + std::to_string(seed));
  constexpr int kQuestions = 1000;
  constexpr double kLimit_m = 100;
  const WorldIndex index(world);
  Questions questions(seed);
  for (int i = 0; i < kQuestions; ++i)
  {
    const Eigen::Vector2d place_m = questions.place(), direction = questions.direction();
    const double range_m = questions.draw(0, kLimit_m), time_s = questions.draw(0, 100);
    const Hit expected = world.cast(place_m, direction, range_m, time_s);
    const Hit hit = index.cast(place_m, direction, range_m, time_s);
    ASSERT_EQ(hit.range_m, expected.range_m) << place_m.transpose() << " " << direction.transpose();
    ASSERT_EQ(hit.object, expected.object) << place_m.transpose() << " " << direction.transpose();
    ASSERT_EQ(index.clearance_m(place_m, range_m, time_s),
              world.clearance_m(place_m, range_m, time_s))
        << place_m.transpose();
  }
}

class WorldIndexOfSite : public testing::TestWithParam<std::string>
{
};
}  // namespace

TEST_P(WorldIndexOfSite, AnswersAsTheWorldDoes)
{
  for (const unsigned seed : {1U, 2U}) expectSameAnswers(makeSite(GetParam(), seed).world, seed);
}

INSTANTIATE_TEST_SUITE_P(All, WorldIndexOfSite, testing::ValuesIn(siteNames()),
                         [](const auto& name) { return name.param; });

//   x . . . . . . . . .      walls on the borders of cells, points on their corners,
//   |     o                  a moving object, and an isolated object far away
//   +-----------
TEST(WorldIndex, AnswersAsTheWorldDoesOnTheBordersOfCells)
{
  World world({{{0, 0}, {5, 0}}, {{0, 0}, {0, 5}}, {{2.5, 0}, {2.5, 2.5}}});
  for (const double x_m : {0.5, 1.0, 1.5}) world.addPoint({x_m, 1});
  world.addPoint({-50, 30});
  world.addArc({{3, 3}, 0.5}, 0, kPi, 40);
  world.addMovingObject({0.3, 1, {{-10, -10}, {10, 10}}});
  for (const unsigned seed : {1U, 2U, 3U}) expectSameAnswers(world, seed);
}

TEST(WorldIndex, ARayAlongABorderOfCellsMeetsTheWallAcrossIt)
{
  const WorldIndex index(World({{{0, 0}, {0, 4}}, {{0, 4}, {4, 4}}, {{4, 4}, {4, 0}}}));
  for (double y_m = 0.25; y_m < 4; y_m += 0.25)
    EXPECT_DOUBLE_EQ(index.cast({1, y_m}, {1, 0}, 30, 0).range_m, 3);
}

TEST(WorldIndex, ARayFromOutsideFindsItsWayIn)
{
  const WorldIndex index(World({{{0, 0}, {0, 4}}}));
  EXPECT_DOUBLE_EQ(index.cast({-1000, 1}, {1, 0}, 2000, 0).range_m, 1000);
  EXPECT_EQ(index.cast({-1000, 1}, {-1, 0}, 2000, 0).object, Hit::kNothing);
  EXPECT_EQ(index.cast({-1000, 1}, {1, 0}, 999, 0).object, Hit::kNothing);
  EXPECT_DOUBLE_EQ(index.clearance_m({-1000, 1}, 1e6, 0), 1000);
}

TEST(WorldIndex, AnEmptyWorldHasNothing)
{
  const WorldIndex index{World()};
  EXPECT_EQ(index.cast({0, 0}, {1, 0}, 30, 0).object, Hit::kNothing);
  EXPECT_EQ(index.cast({0, 0}, {1, 0}, 30, 0).range_m, 30);
  EXPECT_EQ(index.clearance_m({3, 4}, 7, 0), 7);
}

TEST(WorldIndex, ThingsMayLieFarApart)
{
  const WorldIndex index(World({{{0, 0}, {0, 4}}, {{1e6, 0}, {1e6, 4e5}}}));
  EXPECT_DOUBLE_EQ(index.cast({1, 1}, {1, 0}, 2e6, 0).range_m, 1e6 - 1);
  EXPECT_DOUBLE_EQ(index.cast({1, 1}, {-1, 0}, 2e6, 0).range_m, 1);
}
}  // namespace psmks
