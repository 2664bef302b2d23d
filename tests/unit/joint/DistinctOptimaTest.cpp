/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/geometry/Angle.h>
#include <psmks/joint/DistinctOptima.h>

namespace psmks
{
namespace
{
RefinedPose at(const Pose2& T_ref_cur, double logPosterior)
{
  RefinedPose pose;
  pose.T_ref_cur = T_ref_cur;
  pose.logPosterior = logPosterior;
  return pose;
}

const Eigen::Vector2d kNoDirection = Eigen::Vector2d::Zero();
}  // namespace

// Three starts ended at the optimum at x = 2, one at that at x = -1.
TEST(DistinctOptima, AnOptimumThatSeveralStartsReachedCountsOnceAtItsLikeliestPose)
{
  std::vector<RefinedPose> poses{at({2.00, 0, 0}, 9), at({-1, 0, 0}, 9.1), at({2.01, 0.01, 0}, 9.5),
                                 at({1.98, 0, degToRad(1)}, 8.9)};
  keepDistinctOptima(poses, kNoDirection);
  ASSERT_EQ(poses.size(), 2U);
  EXPECT_EQ(poses[0].logPosterior, 9.5);
  EXPECT_EQ(poses[0].T_ref_cur.x_m, 2.01);
  EXPECT_EQ(poses[1].logPosterior, 9.1);
}

// The score says how much of what is seen agrees, not how much is seen.
TEST(DistinctOptima, NotTheScoreOrdersThemButTheLikelihood)
{
  RefinedPose littleSeen = at({}, 2), muchSeen = at({1, 0, 0}, 30);
  littleSeen.score = 1, muchSeen.score = 0.8;
  std::vector<RefinedPose> poses{littleSeen, muchSeen};
  keepDistinctOptima(poses, kNoDirection);
  ASSERT_EQ(poses.size(), 2U);
  EXPECT_EQ(poses[0].T_ref_cur.x_m, 1);
}

TEST(DistinctOptima, AnotherHeadingIsAnotherOptimum)
{
  std::vector<RefinedPose> poses{at({}, 0.9), at({0, 0, degToRad(5)}, 0.9)};
  keepDistinctOptima(poses, kNoDirection);
  EXPECT_EQ(poses.size(), 2U);
}

TEST(DistinctOptima, AlongAnOpenDirectionAllIsOneOptimum)
{
  std::vector<RefinedPose> poses{at({}, 0.9), at({3, 0.05, 0}, 0.9), at({3, 0.5, 0}, 0.8)};
  keepDistinctOptima(poses, Eigen::Vector2d::UnitX());
  EXPECT_EQ(poses.size(), 2U);
}

TEST(DistinctOptima, NoneOfNoneAreLeft)
{
  std::vector<RefinedPose> poses;
  keepDistinctOptima(poses, kNoDirection);
  EXPECT_TRUE(poses.empty());
}
}  // namespace psmks
