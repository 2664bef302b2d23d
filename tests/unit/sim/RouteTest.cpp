/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/sim/Route.h>

#include <sstream>

namespace psmks
{
namespace
{
Route read(const std::string& text)
{
  std::istringstream in(text);
  return readRoute(in);
}

std::string complaintAbout(const std::string& text)
{
  try
  {
    read(text);
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return "none";
}
}  // namespace

TEST(Route, HasAPointALine)
{
  const Route route = read("# to the door\n0 0\n\n  1.5 -2e-1 # and on\r\n3\t4\n");
  ASSERT_EQ(route.size(), 3U);
  EXPECT_EQ(route[1], Eigen::Vector2d(1.5, -0.2));
  EXPECT_EQ(route[2], Eigen::Vector2d(3, 4));
}

TEST(Route, SaysWhichLineIsNoPoint)
{
  EXPECT_EQ(complaintAbout("0 0\n\n1 x\n"), "line 3: expected \"x y\" in metres");
  EXPECT_EQ(complaintAbout("0 0\n1\n"), "line 2: expected \"x y\" in metres");
  EXPECT_EQ(complaintAbout("0 0 0\n1 1\n"), "line 1: expected \"x y\" in metres");
  EXPECT_EQ(complaintAbout("0 0\nnan 1\n"), "line 2: expected \"x y\" in metres");
}

TEST(Route, NeedsTwoPoints)
{
  EXPECT_EQ(complaintAbout(""), "a route needs at least two points");
  EXPECT_EQ(complaintAbout("1 2\n"), "a route needs at least two points");
}
}  // namespace psmks
