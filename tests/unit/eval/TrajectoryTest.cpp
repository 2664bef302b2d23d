/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/eval/Trajectory.h>
#include <psmks/geometry/Angle.h>
#include <tests/support/PoseMatcher.h>
#include <tests/support/ScratchFolder.h>
#include <tests/support/ThrownText.h>

#include <fstream>
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
  EXPECT_NE(
      test::thrownText<TrajectoryFileError>([&] { read("1 2 nan 4\n"); }).find(":1: expected"),
      std::string::npos);
  EXPECT_NE(
      test::thrownText<TrajectoryFileError>([&] { read("2 0 0 0\n1 0 0 0\n"); }).find("earlier"),
      std::string::npos);
  EXPECT_NE(test::thrownText<TrajectoryFileError>([&] { read("# nothing\n"); }).find("no pose"),
            std::string::npos);
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
