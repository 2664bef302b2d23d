/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/sim/MovingObject.h>

namespace psmks
{
//            2 m
//             |
//   0 --------+ 4 m        6 m long, at 2 m/s: 3 s there, 3 s back
TEST(MovingObject, WalksThereAndBackForEver)
{
  const MovingObject person{0.2, 2, {{0, 0}, {4, 0}, {4, 2}}};
  EXPECT_EQ(person.place_m(0), Eigen::Vector2d(0, 0));
  EXPECT_EQ(person.place_m(1), Eigen::Vector2d(2, 0));
  EXPECT_EQ(person.place_m(2.5), Eigen::Vector2d(4, 1));
  EXPECT_EQ(person.place_m(3), Eigen::Vector2d(4, 2));
  EXPECT_EQ(person.place_m(3.5), Eigen::Vector2d(4, 1));
  EXPECT_EQ(person.place_m(5), Eigen::Vector2d(2, 0));
  EXPECT_EQ(person.place_m(6), Eigen::Vector2d(0, 0));
  EXPECT_EQ(person.place_m(7), Eigen::Vector2d(2, 0));
}

TEST(MovingObject, StandsWhereItHasNowhereToGo)
{
  const MovingObject alone{0.2, 1, {{3, 1}}}, onTheSpot{0.2, 1, {{3, 1}, {3, 1}}};
  EXPECT_EQ(alone.place_m(5), Eigen::Vector2d(3, 1));
  EXPECT_EQ(onTheSpot.place_m(5), Eigen::Vector2d(3, 1));
}
}  // namespace psmks
