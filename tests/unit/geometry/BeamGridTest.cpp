/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/geometry/BeamGrid.h>
#include <tests/support/Says.h>
#include <tests/support/ThrownText.h>

#include <limits>
#include <stdexcept>
#include <tuple>

namespace psmks
{
namespace
{
// Half a circle, a ray every 45 degrees:          A whole circle, a ray every 90 degrees:
//
//             4 (90)                                        3 (90)
//        3 .  |  (45)...                                      |
//           \ |                                   0 (-180) ---+--- 2 (0)
//     2 (0) --o        counted from -90                       |
//                                                           1 (-90)
BeamGrid halfCircle() { return BeamGrid::centered(kPi, 5); }
BeamGrid wholeCircle() { return BeamGrid::centered(2 * kPi, 4); }

std::string refusalOf(double firstBearing_rad, double increment_rad, int count)
{
  return test::thrownText<std::invalid_argument>(
      [=] { BeamGrid(firstBearing_rad, increment_rad, count); });
}
}  // namespace

TEST(BeamGrid, AnEmptyGridHasNoRays)
{
  const BeamGrid grid;
  EXPECT_EQ(grid.count(), 0);
  EXPECT_FALSE(grid.closed());
  EXPECT_EQ(grid.fieldOfView_rad(), 0);
  EXPECT_EQ(grid.neighbour(0, 1), -1);
}

TEST(BeamGrid, AnOpenGridIncludesBothEndsOfTheFieldOfView)
{
  const BeamGrid grid = halfCircle();
  EXPECT_FALSE(grid.closed());
  EXPECT_DOUBLE_EQ(grid.fieldOfView_rad(), kPi);
  EXPECT_DOUBLE_EQ(grid.increment_rad(), kPi / 4);
  EXPECT_DOUBLE_EQ(grid.bearing_rad(0), -kPi / 2);
  EXPECT_DOUBLE_EQ(grid.bearing_rad(4), kPi / 2);
}

TEST(BeamGrid, TheRaysOfAClosedGridAreDistinct)
{
  const BeamGrid grid = wholeCircle();
  EXPECT_TRUE(grid.closed());
  EXPECT_DOUBLE_EQ(grid.fieldOfView_rad(), 2 * kPi);
  EXPECT_DOUBLE_EQ(grid.bearing_rad(0), -kPi);
  EXPECT_DOUBLE_EQ(grid.bearing_rad(3), kPi / 2);
}

TEST(BeamGrid, OneRayShortOfTheCircleIsOpen)
{
  EXPECT_TRUE(BeamGrid(0, degToRad(1), 360).closed());
  EXPECT_FALSE(BeamGrid(0, degToRad(1), 359).closed());
}

TEST(BeamGrid, DirectionsAreUnitVectorsAlongTheRays)
{
  const BeamGrid grid = halfCircle();
  for (int i = 0; i < grid.count(); ++i)
  {
    const double bearing_rad = grid.bearing_rad(i);
    EXPECT_EQ(grid.direction(i), Eigen::Vector2d(std::cos(bearing_rad), std::sin(bearing_rad)));
  }
}

TEST(BeamGrid, TheIndexOfARaysBearingIsTheRay)
{
  for (const BeamGrid& grid : {halfCircle(), wholeCircle()})
    for (int i = 0; i < grid.count(); ++i)
      for (const double turns_rad : {0.0, 2 * kPi, -4 * kPi})
        EXPECT_NEAR(grid.index(grid.bearing_rad(i) + turns_rad), i, 1e-12);
}

TEST(BeamGrid, TheIndexIsFractionalBetweenRays)
{
  EXPECT_NEAR(halfCircle().index(degToRad(11.25)), 2.25, 1e-12);
  EXPECT_NEAR(wholeCircle().index(degToRad(45)), 2.5, 1e-12);
}

TEST(BeamGrid, OutsideTheFieldOfViewAnOpenGridAnswersBeyondItsEnds)
{
  const BeamGrid grid = halfCircle();
  EXPECT_NEAR(grid.index(degToRad(135)), 5, 1e-12);
  EXPECT_NEAR(grid.index(degToRad(-135)), -1, 1e-12);
}

TEST(BeamGrid, OnAClosedGridTheSeamIsNoEdge)
{
  const BeamGrid grid = wholeCircle();
  EXPECT_NEAR(grid.index(degToRad(179)), -1 / 90.0, 1e-12);
  EXPECT_NEAR(grid.index(degToRad(-179)), 1 / 90.0, 1e-12);
  EXPECT_NEAR(grid.index(degToRad(134)), 3 + 44 / 90.0, 1e-12);
  EXPECT_NEAR(grid.index(degToRad(136)), -44 / 90.0, 1e-12);
}

TEST(BeamGrid, NeighboursWrapOnAClosedGridOnly)
{
  EXPECT_EQ(wholeCircle().neighbour(3, 1), 0);
  EXPECT_EQ(wholeCircle().neighbour(0, -1), 3);
  EXPECT_EQ(wholeCircle().neighbour(1, -10), 3);
  EXPECT_EQ(halfCircle().neighbour(4, 1), -1);
  EXPECT_EQ(halfCircle().neighbour(0, -1), -1);
  EXPECT_EQ(halfCircle().neighbour(1, 2), 3);
}

TEST(BeamGrid, GridsOfTheSameRaysAreEqual)
{
  EXPECT_EQ(halfCircle(), halfCircle());
  EXPECT_NE(halfCircle(), wholeCircle());
  EXPECT_NE(BeamGrid(0, 0.1, 5), BeamGrid(0, 0.1, 6));
  EXPECT_NE(BeamGrid(0, 0.1, 5), BeamGrid(0.01, 0.1, 5));
}

TEST(BeamGrid, ARefusalNamesTheRuleAndTheValue)
{
  EXPECT_TRUE(test::says(refusalOf(0, -0.5, 3), {"increment", "-0.5"}));
  EXPECT_TRUE(test::says(refusalOf(0, 0, 3), {"increment", "got 0"}));
  EXPECT_TRUE(test::says(refusalOf(0, 1e-12, 3), {"increment", "1e-12"}));
  EXPECT_TRUE(test::says(refusalOf(1e308, 0.5, 3), {"first bearing", "1e+308"}));
  EXPECT_TRUE(test::says(refusalOf(0, 0.5, -7), {"count", "-7"}));
  EXPECT_TRUE(test::says(refusalOf(INFINITY, 0.5, 3), {"first bearing", "inf"}));
  EXPECT_TRUE(test::says(refusalOf(0, std::nan(""), 3), {"increment", "nan"}));
  EXPECT_TRUE(test::says(refusalOf(0, 0.25, 30), {"more than once round", "7.5"}));
}

TEST(BeamGrid, AcceptsWhatTheConstructorTakes)
{
  const double least_rad = BeamGrid::kLeastIncrement_rad;
  EXPECT_TRUE(BeamGrid::accepts(-kPi, degToRad(1), 360));
  EXPECT_TRUE(BeamGrid::accepts(0, least_rad, 628318));
  for (const auto& [first_rad, increment_rad, count] : {std::tuple{1e308, 0.5, 3},
                                                        {std::nan(""), 0.5, 3},
                                                        {0.0, least_rad / 2, 3},
                                                        {0.0, std::nan(""), 3},
                                                        {0.0, 0.25, 30},
                                                        {0.0, 0.5, -1},
                                                        {0.0, least_rad, 2000000000}})
  {
    EXPECT_FALSE(BeamGrid::accepts(first_rad, increment_rad, count));
    EXPECT_NE(refusalOf(first_rad, increment_rad, count), "");
  }
}
}  // namespace psmks
