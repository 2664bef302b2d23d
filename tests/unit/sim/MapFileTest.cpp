/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/sim/MapFile.h>

#include <sstream>

namespace psmks
{
namespace
{
Site read(const std::string& text)
{
  std::istringstream in(text);
  return readMapFile(in);
}

std::string complaintAbout(const std::string& text)
{
  try
  {
    read(text);
  }
  catch (const MapFileError& error)
  {
    return error.what();
  }
  return "none";
}

const std::string kCorner =
    "2D-Map\n"
    "NumLines: 2\n"
    "NumPoints: 1\n"
    "Cairn: RobotHome 500 -250 90 \"\" ICON \"\"\n"
    "LINES\n"
    "0 0 4000 0\n"
    "4000 0 4000 3000\n"
    "DATA\n"
    "1000 1500\n";
}  // namespace

//           | 3 m
//   o       |          o = (1, 1.5), a point
//   --------+
//   0       4 m
TEST(MapFile, BecomesWallsAndPointsInMetres)
{
  const World world = read(kCorner).world;
  ASSERT_EQ(world.walls().size(), 2U);
  EXPECT_EQ(world.walls()[1].a, Eigen::Vector2d(4, 0));
  EXPECT_EQ(world.walls()[1].b, Eigen::Vector2d(4, 3));
  ASSERT_EQ(world.points().size(), 1U);
  EXPECT_EQ(world.points()[0].centre_m, Eigen::Vector2d(1, 1.5));
  EXPECT_EQ(world.points()[0].circle, World::Point::kNoCircle);
}

TEST(MapFile, TheRobotStartsAtItsHome)
{
  const Pose2 start = read(kCorner).T_world_start;
  EXPECT_DOUBLE_EQ(start.x_m, 0.5);
  EXPECT_DOUBLE_EQ(start.y_m, -0.25);
  EXPECT_DOUBLE_EQ(start.phi_rad, kPi / 2);
  EXPECT_EQ(read("2D-Map\nLINES\n").T_world_start.x_m, 0);
}

TEST(MapFile, MayComeFromWindows)
{
  std::string text;
  for (const char c : kCorner) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_EQ(read(text).world.walls().size(), 2U);
  EXPECT_EQ(read(text).world.points().size(), 1U);
}

TEST(MapFile, UnknownHeadersAreIgnored)
{
  const Site site =
      read("2D-Map\nMapInfo: GoalType Name=Goal\nCairn: Goal 1 2 0 \"\"\nLINES\n1 2 3 4\n");
  EXPECT_EQ(site.world.walls().size(), 1U);
}

TEST(MapFile, SectionsMayBeEmptyOrMissing)
{
  EXPECT_TRUE(read("2D-Map\nNumLines: 0\nLINES\nDATA\n").world.walls().empty());
  EXPECT_EQ(read("2D-Map\nDATA\n5 5\n").world.points().size(), 1U);
  EXPECT_TRUE(read("2D-Map\n").world.points().empty());
}

TEST(MapFile, WhatIsThereCountsNotWhatWasAnnounced)
{
  EXPECT_EQ(read("2D-Map\nNumLines: 7\nLINES\n0 0 1 1\n").world.walls().size(), 1U);
  EXPECT_EQ(read("2D-Map\nNumPoints: 1\nDATA\n0 0\n1 1\n").world.points().size(), 2U);
}

TEST(MapFile, SaysWhichLineIsWrongAndWhy)
{
  EXPECT_EQ(complaintAbout(""), "line 1: expected '2D-Map': not a map");
  EXPECT_EQ(complaintAbout("LINES\n0 0 1 1\n"), "line 1: expected '2D-Map': not a map");
  EXPECT_EQ(complaintAbout("2D-Map\nLINES\n0 0 1\n"), "line 3: expected 4 numbers, found '0 0 1'");
  EXPECT_EQ(complaintAbout("2D-Map\nDATA\n1 1\n1 one\n"),
            "line 4: expected 2 numbers, found '1 one'");
  EXPECT_EQ(complaintAbout("2D-Map\nDATA\n1 inf\n"), "line 3: expected 2 numbers, found '1 inf'");
  EXPECT_EQ(complaintAbout("2D-Map\nCairn: RobotHome 0 \"\"\n"),
            "line 2: expected 3 numbers, found 'Cairn: RobotHome 0 \"\"'");
}
}  // namespace psmks
