/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/mrpt/SurfaceField.h>
#include <tests/support/RandomNumbers.h>

#include <cmath>

namespace psmks::test
{
namespace
{
/** A wall from (-5, y) to (5, y) with points every 2 cm. */
void addWall(SurfaceField& field, double y_m, double sigma_m, RandomNumbers& random)
{
  for (double x_m = -5; x_m <= 5; x_m += 0.02) field.add({x_m, y_m + random.normal(sigma_m)});
}
}  // namespace

TEST(SurfaceField, KnowsPlaceDirectionAndNoiseOfAWall)
{
  RandomNumbers random(1);
  SCOPED_TRACE(random.seedText());
  SurfaceField field;
  addWall(field, 2, 0.01, random);
  for (int level = 0; level < SurfaceField::kLevels; ++level)
  {
    const Surface* s = field.at({1, 2.03}, level);
    ASSERT_TRUE(s) << level;
    EXPECT_NEAR(s->mean_m.y(), 2, 0.01);
    EXPECT_NEAR(std::abs(s->normal.y()), 1, 0.01);
    EXPECT_NEAR(std::sqrt(s->acrossVariance_m2), 0.01, 0.006);
    EXPECT_NEAR(std::sqrt(12 * s->alongVariance_m2), s->window_m, 0.05);  // even
    EXPECT_NEAR(s->points, s->window_m / 0.02, 2);
  }
}

//  ======   two walls, 6 cm apart: one that errors of the map have doubled
//  ======
TEST(SurfaceField, TakesADoubledWallForAThickOne)
{
  RandomNumbers random(2);
  SCOPED_TRACE(random.seedText());
  SurfaceField field;
  addWall(field, 1.97, 0.005, random);
  addWall(field, 2.03, 0.005, random);
  const Surface* s = field.at({0, 2}, 0);
  ASSERT_TRUE(s);
  EXPECT_NEAR(s->mean_m.y(), 2, 0.005);
  EXPECT_NEAR(std::sqrt(s->acrossVariance_m2), 0.03, 0.004);
}

//    .  a post       ........   a wall, which goes on to the right of its end
TEST(SurfaceField, KnowsAPostFromTheEndOfAWall)
{
  SurfaceField field;
  for (int i = 0; i < 8; ++i) field.add({3 + 0.05 * std::cos(i), 3 + 0.05 * std::sin(i)});
  for (double x_m = 0; x_m <= 2; x_m += 0.02) field.add({x_m, 0});
  const Surface *post = field.at({3, 3}, 0), *end = field.at({0.02, 0.01}, 0),
                *middle = field.at({1, 0.01}, 0);
  ASSERT_TRUE(post && end && middle);
  EXPECT_TRUE(post->isIsolated);
  EXPECT_FALSE(end->isIsolated);
  EXPECT_FALSE(middle->isIsolated);
}

TEST(SurfaceField, HasNoSurfaceOfFewerThanThreePoints)
{
  SurfaceField field;
  EXPECT_EQ(field.at({0, 0}, 0), nullptr);
  field.add({0.01, 0});
  field.add({0.02, 0});
  field.clear();
  field.add({0.01, 0});
  field.add({0.02, 0});
  EXPECT_EQ(field.at({0, 0}, 0), nullptr);
  EXPECT_EQ(field.at({50, 0}, 0), nullptr);
}

TEST(SurfaceField, LooksFurtherWherePointsAreSparse)
{
  SurfaceField field;
  for (double x_m = -3; x_m <= 3; x_m += 0.2) field.add({x_m, 1});
  EXPECT_EQ(field.at({0.1, 1}, 0), nullptr);
  const Surface* s = field.finestAt({0.1, 1}, 0, SurfaceField::kLevels - 1);
  ASSERT_TRUE(s);
  EXPECT_GT(s->window_m, 0.4);
  EXPECT_LT(s->window_m, 1);
  EXPECT_NEAR(s->mean_m.y(), 1, 1e-12);
}

TEST(SurfaceField, KeepsSurfacesWhereTheyAreWhenMoreAreAsked)
{
  RandomNumbers random(3);
  SCOPED_TRACE(random.seedText());
  SurfaceField field;
  addWall(field, 0, 0.01, random);
  const Surface* first = field.at({0, 0}, 0);
  const Eigen::Vector2d mean_m = first->mean_m;
  for (double x_m = -5; x_m < 5; x_m += 0.01) field.at({x_m, 0}, 0);
  EXPECT_EQ(field.at({0, 0}, 0), first);
  EXPECT_EQ(first->mean_m, mean_m);
}

TEST(SurfaceField, HasNothingAtTheEndOfTheWorld)
{
  SurfaceField field;
  field.add({0, 0});
  EXPECT_EQ(field.at({1e300, -1e300}, 0), nullptr);
}
}  // namespace psmks::test
