/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/eval/RelationStatistics.h>
#include <psmks/geometry/Angle.h>
#include <tests/support/PoseMatcher.h>
#include <tests/support/Says.h>
#include <tests/support/ScratchFolder.h>
#include <tests/support/ThrownText.h>

#include <cstdlib>
#include <fstream>

namespace psmks
{
namespace
{
using test::says;
using test::thrownText;

class RelationsTest : public testing::Test
{
 protected:
  std::vector<Relation> read(const std::string& text) const
  {
    std::ofstream(path_) << text;
    return readRelations(path_);
  }

  const test::ScratchFolder folder_;
  const std::string path_ = folder_.path("relations");
};

//   t = 2, 3  <--.        up one metre at t = 1, to the left at t = 2
//             |   |
//   t = 0  -> t = 1
const Trajectory kCorner{{0, {0, 0, 0}}, {1, {1, 0, kPi / 2}}, {2, {1, 1, kPi}}, {3, {0, 1, kPi}}};

/** The true motions between all places of the corner. */
const std::vector<Relation> kTrueRelations{{0, 1, {1, 0, kPi / 2}},
                                           {1, 2, {1, 0, kPi / 2}},
                                           {2, 3, {1, 0, 0}},
                                           {0, 3, {0, 1, kPi}},
                                           {3, 0, {0, 1, -kPi}}};

double largest_m(const std::vector<RelationError>& errors)
{
  double largest = 0;
  for (const auto& e : errors) largest = std::max(largest, e.error_m);
  return largest;
}

TEST_F(RelationsTest, AreReadAndProjectedToThePlane)
{
  const auto relations = read(
      "# t1 t2 x y z roll pitch yaw\n% more\n\n"
      "10.5 12.25 1 -2 0.3 0.01 -0.02 3\n12 3 0 0 0 0 0 4 # backwards\n");
  ASSERT_EQ(relations.size(), 2u);
  EXPECT_EQ(relations[0].from_s, 10.5);
  EXPECT_EQ(relations[0].to_s, 12.25);
  EXPECT_TRUE(isNearly(relations[0].T_from_to, {1, -2, 3}, 1e-12, 1e-12));
  EXPECT_EQ(relations[1].to_s, 3);
  EXPECT_NEAR(relations[1].T_from_to.phi_rad, 4 - 2 * kPi, 1e-12);
}

TEST_F(RelationsTest, DamagedFilesAreRefusedWithTheirLine)
{
  const auto complaint = [this](const std::string& text)
  { return thrownText<TrajectoryFileError>([&] { read(text); }); };
  EXPECT_TRUE(says(complaint("0 1 0 0 0 0 0 0\n0 1 0 0 0 0 0\n"), {path_, ":2: expected"}));
  EXPECT_TRUE(says(complaint("0 1 0 0 0 0 0 east\n"), {":1: expected", "yaw"}));
  EXPECT_TRUE(says(complaint("0 1 0 0 0 0 0 nan\n"), {":1: expected"}));
  EXPECT_TRUE(says(complaint("# none\n"), {"holds no relation"}));
  EXPECT_TRUE(says(thrownText<TrajectoryFileError>([] { readRelations("/no/such/file"); }),
                   {"/no/such/file", "no such file"}));
}

TEST_F(RelationsTest, APerfectTrajectoryHasNoErrorWhereverItsWorldBegins)
{
  const Pose2 T_other_world{-7, 3, 2};
  Trajectory moved = kCorner;
  for (auto& [stamp_s, pose] : moved) pose = T_other_world * pose;
  for (const auto& trajectory : {kCorner, moved})
  {
    const auto errors = relationErrors(trajectory, kTrueRelations);
    ASSERT_EQ(errors.size(), kTrueRelations.size());
    for (const auto& e : errors)
    {
      EXPECT_NEAR(e.error_m, 0, 1e-12);
      EXPECT_NEAR(e.error_rad, 0, 1e-12);
    }
    EXPECT_EQ(errors[0].span_s, 1);
    EXPECT_EQ(errors[3].span_s, 3);
    EXPECT_EQ(errors[4].span_s, 3) << "the span of a relation back in time";
  }
}

TEST_F(RelationsTest, TheErrorIsThatOfTheMotionNotOfThePose)
{
  Trajectory estimate = kCorner;
  estimate[1].pose.y_m += 0.3;  // one pose is wrong: only the relations with it have errors
  estimate[1].pose.phi_rad -= 0.1;
  const auto errors = relationErrors(estimate, kTrueRelations);
  ASSERT_EQ(errors.size(), 5u);
  EXPECT_NEAR(errors[0].error_m, 0.3, 1e-12);
  EXPECT_NEAR(errors[0].error_rad, 0.1, 1e-12);
  EXPECT_NEAR(errors[1].error_rad, 0.1, 1e-12);
  for (const std::size_t i : {2, 3, 4}) EXPECT_NEAR(errors[i].error_m, 0, 1e-12);
}

TEST_F(RelationsTest, APoseCountsWithinTheToleranceOfItsStamp)
{
  Trajectory estimate = kCorner;
  for (auto& [stamp_s, pose] : estimate) stamp_s += 0.9 * kStampTolerance_s;
  EXPECT_EQ(relationErrors(estimate, kTrueRelations).size(), 5u);
  for (auto& [stamp_s, pose] : estimate) stamp_s += 0.2 * kStampTolerance_s;
  EXPECT_TRUE(relationErrors(estimate, kTrueRelations).empty());
  EXPECT_TRUE(relationErrors({}, kTrueRelations).empty());
  EXPECT_TRUE(relationErrors(kCorner, {}).empty());
}

TEST_F(RelationsTest, RelationsThatAreNotCoveredAreLeftOut)
{
  const Trajectory end(kCorner.begin() + 2, kCorner.end());
  const auto errors = relationErrors(end, kTrueRelations);
  ASSERT_EQ(errors.size(), 1u) << "from 2 s to 3 s";
  EXPECT_NEAR(errors[0].error_m, 0, 1e-12);
}

TEST_F(RelationsTest, TheNearestPoseCounts)
{
  Trajectory estimate = kCorner;
  estimate.insert(estimate.begin() + 1, {1 - 0.01, {50, 0, 0}});
  estimate.insert(estimate.begin() + 3, {1 + 0.01, {50, 0, 0}});
  EXPECT_NEAR(largest_m(relationErrors(estimate, kTrueRelations)), 0, 1e-12);
}

TEST_F(RelationsTest, StampsMayGoBackwards)
{
  const Trajectory reversed(kCorner.rbegin(), kCorner.rend());
  const auto errors = relationErrors(reversed, kTrueRelations);
  EXPECT_EQ(errors.size(), 5u);
  EXPECT_NEAR(largest_m(errors), 0, 1e-12);
}

TEST_F(RelationsTest, OfPosesWithOneStampTheFirstCounts)
{
  Trajectory estimate = kCorner;
  estimate.insert(estimate.begin() + 2, {1, {50, 0, 0}});
  for (const double shift_s : {0.0, 0.005, -0.005})  // poses are found on both sides of the stamp
  {
    std::vector<Relation> relations = kTrueRelations;
    for (auto& r : relations)
    {
      r.from_s += shift_s;
      r.to_s += shift_s;
    }
    EXPECT_NEAR(largest_m(relationErrors(estimate, relations)), 0, 1e-12) << shift_s;
  }
}

TEST_F(RelationsTest, AreToldApartByTheTimeTheySpan)
{
  const std::vector<RelationError> errors{{1, 0.1, 0}, {5, 0.2, 0}, {60, 0.4, 0}};
  EXPECT_EQ(errorsSpanning(errors).size(), 3u);
  EXPECT_EQ(errorsSpanning(errors, 0, 5).size(), 1u);
  EXPECT_EQ(errorsSpanning(errors, 5).size(), 2u);

  Trajectory estimate = kCorner;
  estimate[3] = {20, {0, 1.5, kPi}};
  const auto statistics =
      relationStatistics(estimate, {{0, 1, {1, 0, kPi / 2}}, {0, 20, {0, 1, kPi}}});
  EXPECT_EQ(statistics.all.count, 2u);
  EXPECT_NEAR(statistics.all.translation_m.mean, 0.25, 1e-12);
  EXPECT_EQ(statistics.shortSpans.count, 1u);
  EXPECT_NEAR(statistics.shortSpans.translation_m.mean, 0, 1e-12);
}

TEST_F(RelationsTest, OfRealLogsAreRead)
{
  const char* folder = std::getenv("PSMKS_DATA_DIR");
  if (!folder) GTEST_SKIP() << "PSMKS_DATA_DIR is not set";
  EXPECT_EQ(readRelations(std::string(folder) + "/fr079.relations").size(), 1685u);
  EXPECT_EQ(readRelations(std::string(folder) + "/intel.relations").size(), 420u);
}
}  // namespace
}  // namespace psmks
