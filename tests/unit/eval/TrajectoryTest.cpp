/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/eval/Trajectory.h>
#include <psmks/geometry/Angle.h>
#include <tests/support/PoseMatcher.h>
#include <tests/support/ScratchFolder.h>
#include <tests/support/ThrownText.h>

#include <fstream>
#include <iomanip>
#include <sstream>

namespace psmks
{
namespace
{
class TrajectoryTest : public testing::Test
{
 protected:
  Trajectory read(const std::string& text) const
  {
    std::ofstream(path_) << text;
    return readTrajectory(path_);
  }

  const test::ScratchFolder folder_;
  const std::string path_ = folder_.path("trajectory");
};

TEST_F(TrajectoryTest, TumIsReadAsItIsWritten)
{
  const Trajectory written{{1600000000.123456789, {1, -2, degToRad(170)}},
                           {1600000000.5, {3, 4, degToRad(-30)}}};
  std::ostringstream text;
  writeTum(text, written);
  EXPECT_EQ(text.str().substr(0, 20), "1600000000.123456717");  // the double nearest to it
  const Trajectory trajectory = read(text.str());
  ASSERT_EQ(trajectory.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i)
  {
    EXPECT_NEAR(trajectory[i].stamp_s, written[i].stamp_s, 1e-6);
    EXPECT_TRUE(isNearly(trajectory[i].pose, written[i].pose, 1e-8, 1e-8));
  }
}

TEST_F(TrajectoryTest, MrptGroundTruthIsReadAsItIsWritten)
{
  const Trajectory written{{1e9, {1, -2, degToRad(170)}}, {1e9 + 0.5, {3, 4, degToRad(-30)}}};
  std::ostringstream text;
  writeMrptGroundTruth(text, written);
  const Trajectory trajectory = read(text.str());
  ASSERT_EQ(trajectory.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i)
  {
    EXPECT_EQ(trajectory[i].stamp_s, written[i].stamp_s);
    EXPECT_TRUE(isNearly(trajectory[i].pose, written[i].pose, 1e-8, 1e-8));
  }
}

TEST_F(TrajectoryTest, MrptGroundTruthIsReadAndCommentsAreSkipped)
{
  const Trajectory trajectory = read("% time x y phi\n# another\n\n10.5 1 2 3\n11 4 5 -3 % end\n");
  ASSERT_EQ(trajectory.size(), 2u);
  EXPECT_EQ(trajectory[0].stamp_s, 10.5);
  EXPECT_TRUE(isNearly(trajectory[1].pose, {4, 5, -3}, 1e-12, 1e-12));
}

TEST_F(TrajectoryTest, DamagedFilesAreRefusedWithTheirLine)
{
  EXPECT_NE(
      test::thrownText<TrajectoryFileError>([&] { read("1 2 3 4\n1 2 3\n"); }).find(":2: expected"),
      std::string::npos);
  EXPECT_NE(
      test::thrownText<TrajectoryFileError>([&] { read("1 2 3 abc\n"); }).find(":1: expected"),
      std::string::npos);
  EXPECT_NE(test::thrownText<TrajectoryFileError>([&] { read("1 2 nan 4\n"); })
                .find("none of its 1 rows has a position"),
            std::string::npos);
  EXPECT_NE(
      test::thrownText<TrajectoryFileError>([&] { read("1 nan nan\n"); }).find(":1: expected"),
      std::string::npos);
  EXPECT_NE(
      test::thrownText<TrajectoryFileError>([&] { read("2 0 0 0\n1 0 0 0\n"); }).find("earlier"),
      std::string::npos);
  EXPECT_NE(test::thrownText<TrajectoryFileError>([&] { read("# nothing\n"); }).find("no pose"),
            std::string::npos);
}

TEST_F(TrajectoryTest, AQuaternionMayHaveAnyLength)
{
  const double half_rad = degToRad(35);
  for (const double length : {1e-3, 1.0, 2.0, 1e3})
  {
    std::ostringstream text;
    text << std::setprecision(17) << "1 2 3 0 0 0 " << length * std::sin(half_rad) << ' '
         << length * std::cos(half_rad) << '\n';
    EXPECT_NEAR(read(text.str())[0].pose.phi_rad, degToRad(70), 1e-12) << length;
  }
}

TEST_F(TrajectoryTest, AZeroQuaternionAndOneOfNansStateNoHeading)
{
  std::ofstream(path_) << "1 2 3 0 0 0 0 0\n2 2 3 0 nan nan nan nan\n3 2 3 0 0 0 0 1\n";
  const TrajectoryFile file = readTrajectoryFile(path_);
  ASSERT_EQ(file.trajectory.size(), 3u);
  EXPECT_FALSE(file.trajectory[0].hasHeading());
  EXPECT_FALSE(file.trajectory[1].hasHeading());
  EXPECT_TRUE(file.trajectory[2].hasHeading());
  EXPECT_EQ(file.posesWithoutHeading, 2);
  ASSERT_EQ(file.remarks().size(), 1u);
  EXPECT_NE(file.remarks()[0].find("2 of 3 rows have no heading"), std::string::npos);
}

//  4   3     Measured by a total station: the path turns, and all quaternions are the identity.
//      |     On a straight way (2) an identity is a heading.
//  1---2
TEST_F(TrajectoryTest, IdentitiesThroughoutATurningPathStateNoHeading)
{
  const std::string straight = "1 0 0 0 0 0 0 1\n2 3 0 0 0 0 0 1\n";
  EXPECT_TRUE(read(straight)[1].hasHeading());
  const Trajectory turning = read(straight + "3 3 3 0 0 0 0 1\n4 0 3 0 0 0 0 1\n");
  for (const StampedPose& pose : turning) EXPECT_FALSE(pose.hasHeading());
}

TEST_F(TrajectoryTest, RowsWithoutAPositionAreLeftOutAndCounted)
{
  std::ofstream(path_) << "1 nan nan nan nan nan nan nan\n2 5 6 0 0 0 0 1\nnan 1 1 0 0 0 0 1\n"
                       << "3 inf 1 0 0 0 0 1\n";
  const TrajectoryFile file = readTrajectoryFile(path_);
  ASSERT_EQ(file.trajectory.size(), 1u);
  EXPECT_EQ(file.trajectory[0].pose.x_m, 5);
  EXPECT_EQ(file.rows, 4);
  EXPECT_EQ(file.rowsWithoutPosition, 3);
  EXPECT_NE(file.remarks().at(0).find("3 of 4 rows have no position"), std::string::npos);
}

TEST_F(TrajectoryTest, StampsThatGoBackwardsAreReadWhereTheyAreExpected)
{
  std::ofstream(path_) << "2 0 0 0\n1 5 0 0\n1 6 0 0\n";
  const Trajectory trajectory = readTrajectory(path_, StampOrder::Any);
  ASSERT_EQ(trajectory.size(), 3u);
  EXPECT_EQ(trajectory[1].stamp_s, 1);
  EXPECT_EQ(trajectory[2].pose.x_m, 6);
}
}  // namespace
}  // namespace psmks
