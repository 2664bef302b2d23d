/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/eval/PathErrors.h>
#include <psmks/geometry/Angle.h>
#include <tests/support/PoseMatcher.h>

#include <functional>

namespace psmks
{
namespace
{
using Common = std::vector<CommonPose>;

/** A square of 4 m, anticlockwise, one pose a metre: 17 poses, the last on the first.
 *
 *      <---.
 *      |   |
 *      '-->'                 */
std::vector<Pose2> square()
{
  std::vector<Pose2> poses{{0, 0, 0}};
  for (int side = 0; side < 4; ++side)
    for (int metre = 1; metre <= 4; ++metre)
      poses.push_back(poses.back() * Pose2{1, 0, metre == 4 ? kPi / 2 : 0});
  return poses;
}

/** The square as the truth, with an estimate of each pose. */
Common squareSeenAs(const std::function<Pose2(std::size_t, const Pose2&)>& estimate)
{
  Common common;
  for (const Pose2& pose : square())
  {
    const std::size_t i = common.size();
    common.push_back({static_cast<double>(i), estimate(i, pose), pose, true});
  }
  return common;
}

/** An estimate with errors of all kinds that depend on the index alone. */
Pose2 spoiled(std::size_t i, const Pose2& pose)
{
  const double n = static_cast<double>(i);
  return pose * Pose2{0.01 * std::sin(n), 0.02 * std::cos(3 * n), 0.03 * std::sin(5 * n)} *
         Pose2{0, 0.001 * n, 0};
}

/** All errors of all measures in one list. */
std::vector<double> allErrors(const Common& common)
{
  std::vector<double> row;
  for (const auto& errors :
       {absoluteErrors(common, alignAtFirstPose(common)), absoluteErrors(common, align(common)),
        stepErrors(common), driftErrors(common, 2.5)})
    for (const auto& [translation_m, rotation_rad] : errors)
    {
      row.push_back(translation_m);
      row.push_back(rotation_rad);
    }
  return row;
}

void expectSame(const std::vector<double>& a, const std::vector<double>& b)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-9) << i;
}

TEST(PathErrorsTest, ARigidMotionOfTheWorldIsUndone)
{
  const Pose2 T_truth_estimate{-3, 7, 2.5};
  const Common common = squareSeenAs([&](std::size_t, const Pose2& pose)
                                     { return T_truth_estimate.inverse() * pose; });
  EXPECT_TRUE(isNearly(alignAtFirstPose(common), T_truth_estimate, 1e-12, 1e-12));
  EXPECT_TRUE(isNearly(align(common), T_truth_estimate, 1e-12, 1e-12));
  for (const double error : allErrors(common)) EXPECT_NEAR(error, 0, 1e-12);
}

TEST(PathErrorsTest, AreThoseOfTheMotionWhereverTheWorldsBegin)
{
  const auto errors = allErrors(squareSeenAs(spoiled));
  const Pose2 T_elsewhere{100, -50, -1.2};
  Common moved = squareSeenAs([&](std::size_t i, const Pose2& pose)
                              { return T_elsewhere * spoiled(i, pose); });
  expectSame(allErrors(moved), errors);
  for (CommonPose& pose : moved) pose.T_true = T_elsewhere.inverse() * pose.T_true;
  expectSame(allErrors(moved), errors);
}

TEST(PathErrorsTest, AreTheSameInAMirror)
{
  const auto mirrored = [](const Pose2& p) { return Pose2{p.x_m, -p.y_m, wrapAngle(-p.phi_rad)}; };
  Common common = squareSeenAs(spoiled);
  const auto errors = allErrors(common);
  for (CommonPose& pose : common)
  {
    pose.T_true = mirrored(pose.T_true);
    pose.T_estimated = mirrored(pose.T_estimated);
  }
  expectSame(allErrors(common), errors);
}

TEST(PathErrorsTest, NoRigidMotionIsBetterThanTheAlignment)
{
  const Common common = squareSeenAs(spoiled);
  const auto squares_m2 = [&common](const Pose2& T_truth_estimate)
  {
    double sum_m2 = 0;
    for (const auto& error : absoluteErrors(common, T_truth_estimate))
      sum_m2 += error.translation_m * error.translation_m;
    return sum_m2;
  };
  const Pose2 best = align(common);
  for (const Pose2& off : {Pose2{1e-3, 0, 0}, Pose2{0, 1e-3, 0}, Pose2{0, 0, 1e-3}})
  {
    EXPECT_GT(squares_m2(best * off), squares_m2(best));
    EXPECT_GT(squares_m2(best * off.inverse()), squares_m2(best));
  }
  EXPECT_GT(squares_m2(alignAtFirstPose(common)), squares_m2(best));
}

TEST(PathErrorsTest, ARobotAtRestIsAlignedByItsHeading)
{
  const Common common{{0, {2, 1, 0.5}, {5, 5, 1.5}, true}, {1, {2, 1, 0.5}, {5, 5, 1.5}, true}};
  for (const auto& error : absoluteErrors(common, align(common)))
  {
    EXPECT_NEAR(error.translation_m, 0, 1e-12);
    EXPECT_NEAR(error.rotation_rad, 0, 1e-12);
  }
}

//  truth     o--o--o--o        estimate  x--x  x--x     one step of 1.2 m, and all after it shifted
TEST(PathErrorsTest, OneWrongStepIsOneStepErrorAndManyOfPoses)
{
  const Common common = squareSeenAs(
      [](std::size_t i, const Pose2& pose) {
        return Pose2{i < 3 ? 0 : 0.2, 0, 0} * pose;
      });
  const auto steps = stepErrors(common);
  ASSERT_EQ(steps.size(), 16u);
  for (std::size_t i = 0; i < steps.size(); ++i)
    EXPECT_NEAR(steps[i].translation_m, i == 2 ? 0.2 : 0, 1e-12) << i;
  const auto poses = absoluteErrors(common, alignAtFirstPose(common));
  for (std::size_t i = 0; i < poses.size(); ++i)
    EXPECT_NEAR(poses[i].translation_m, i < 3 ? 0 : 0.2, 1e-12) << i;
}

TEST(PathErrorsTest, StepsRunBetweenMeasuredPoses)
{
  Common common = squareSeenAs([](std::size_t, const Pose2& pose) { return pose; });
  common[1].isMeasured = common[2].isMeasured = false;
  common[1].T_true.x_m += 9;  // on a line between poses far apart, and no measurement
  const auto steps = stepErrors(common);
  ASSERT_EQ(steps.size(), 14u);
  for (const auto& step : steps) EXPECT_NEAR(step.translation_m, 0, 1e-12);
}

TEST(PathErrorsTest, AWrongScaleDriftsEvenlyAlongAStraight)
{
  Common common;
  for (int i = 0; i <= 40; ++i)
    common.push_back({0.1 * i, {1.02 * 0.3 * i, 0, 0.01 * 0.3 * i}, {0.3 * i, 0, 0}, true});
  for (const double length_m : {1.0, 5.0})
  {
    const auto errors = driftErrors(common, length_m);
    ASSERT_GT(errors.size(), 20u);
    for (const auto& error : errors) EXPECT_NEAR(error.rotation_rad, 0.01 * length_m, 1e-9);
  }
  EXPECT_NEAR(driftErrors(common, 1)[0].translation_m, 0.02, 1e-12);
  EXPECT_EQ(driftErrors(common, 11.9).size(), 1u) << "from the first pose, 12 m before the last";
  EXPECT_TRUE(driftErrors(common, 12.1).empty());
}

TEST(PathErrorsTest, TheTruePathIsMeasured)
{
  const auto lengths_m = truePathLengths_m(squareSeenAs(spoiled));
  ASSERT_EQ(lengths_m.size(), 17u);
  for (std::size_t i = 0; i < 17; ++i) EXPECT_NEAR(lengths_m[i], static_cast<double>(i), 1e-12);
}

TEST(PathErrorsTest, WithoutHeadingsOnlyPositionsAreCompared)
{
  Common common = squareSeenAs(
      [](std::size_t, const Pose2& pose) {
        return Pose2{-3, 1, 0.7} * pose;
      });
  for (CommonPose& pose : common) pose.T_true.phi_rad = std::nan("");
  for (const Pose2& T : {alignAtFirstPose(common), align(common)})
    for (const PairError& error : absoluteErrors(common, T))
    {
      EXPECT_NEAR(error.translation_m, 0, 1e-9);
      EXPECT_TRUE(std::isnan(error.rotation_rad));
    }
  EXPECT_TRUE(stepErrors(common).empty());
  EXPECT_TRUE(driftErrors(common, 3).empty());
  common[5].T_true.phi_rad = common[6].T_true.phi_rad = kPi / 2;
  EXPECT_EQ(stepErrors(common).size(), 1u);
}

TEST(PathErrorsTest, WithoutPosesThereIsNoError)
{
  EXPECT_TRUE(isNearly(align({}), {}, 0, 0));
  EXPECT_TRUE(isNearly(alignAtFirstPose({}), {}, 0, 0));
  EXPECT_TRUE(allErrors({}).empty());
}
}  // namespace
}  // namespace psmks
