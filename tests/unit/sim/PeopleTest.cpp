/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/sim/People.h>
#include <psmks/sim/World.h>

namespace psmks
{
TEST(People, WalkWhereTheyFitAndStartAwayFromTheRobot)
{
  const World room = World::smallRoom();
  const Eigen::Vector2d robot_m(0, -4);
  const auto people = peopleAround(room, robot_m, 4, 2);
  ASSERT_EQ(people.size(), 4U);
  for (const MovingObject& person : people)
  {
    EXPECT_GT(person.speed_mps, 0);
    ASSERT_GT(person.path_m.size(), 1U);
    EXPECT_GE((person.path_m.front() - robot_m).norm(), 2);
    for (const Eigen::Vector2d& corner_m : person.path_m)
      EXPECT_GT(room.clearance_m(corner_m, 10, 0), 0) << corner_m.transpose();
  }
}

TEST(People, AreTheSameForTheSameSeedAndOthersForAnother)
{
  const World room = World::smallRoom();
  const auto first = peopleAround(room, {0, -4}, 2, 2), same = peopleAround(room, {0, -4}, 2, 2),
             other = peopleAround(room, {0, -4}, 2, 3);
  ASSERT_EQ(first.size(), 2U);
  ASSERT_EQ(other.size(), 2U);
  EXPECT_EQ(first[1].path_m, same[1].path_m);
  EXPECT_NE(first[1].path_m, other[1].path_m);
}

//   +---+    a closet of 1 m, in which nobody can walk
//   | o |
//   +---+
TEST(People, AreFewerThanWantedWhereThereIsNoSpace)
{
  World closet;
  closet.addBox({0, 0}, {1, 1});
  EXPECT_TRUE(peopleAround(closet, {0, 0}, 3, 1).empty());
}
}  // namespace psmks
