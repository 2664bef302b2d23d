/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/geometry/Angle.h>
#include <psmks/geometry/Innovation.h>
#include <tests/support/RandomNumbers.h>

#include <Eigen/LU>

namespace psmks
{
namespace
{
/** J'J of random rows: symmetric, positive definite. */
Eigen::Matrix3d randomPositiveDefinite(test::RandomNumbers& random, double scale)
{
  Eigen::Matrix3d J;
  for (int i = 0; i < J.size(); ++i) J(i / 3, i % 3) = random.normal(scale);
  return J.transpose() * J + 0.01 * scale * scale * Eigen::Matrix3d::Identity();
}

Eigen::Vector3d randomError(test::RandomNumbers& random)
{
  return {random.normal(0.1), random.normal(0.1), random.normal(0.05)};
}

Pose2 poseOf(const Eigen::Vector3d& x) { return {x.x(), x.y(), x.z()}; }
}  // namespace

// Scans whose cost is quadratic about x_scans, a guess at x_guess, and an estimate anywhere
// between: the innovation is that of x_scans and x_guess, however far the guess has pulled the
// estimate.
TEST(InnovationTest, HoldsTheGuessAgainstTheScansAloneWhereverTheEstimateIs)
{
  test::RandomNumbers random(7);
  SCOPED_TRACE(random.seedText());
  for (int i = 0; i < 200; ++i)
  {
    const Eigen::Matrix3d P = randomPositiveDefinite(random, 0.05);
    const Eigen::Matrix3d H = randomPositiveDefinite(random, 50);
    const Eigen::Vector3d guess = randomError(random), scans = randomError(random);
    const Eigen::Vector3d nu = scans - guess;
    const Eigen::Matrix3d S = P + H.inverse();
    const double expected = nu.dot(S.inverse() * nu);

    const Eigen::Matrix3d weight = H + P.inverse();
    const Eigen::Vector3d pulled = weight.inverse() * (H * scans + P.inverse() * guess);
    for (const Eigen::Vector3d& estimate : {scans, pulled, guess})
    {
      const Innovation found =
          innovation({poseOf(guess), P}, poseOf(estimate), H, H * (scans - estimate));
      EXPECT_NEAR(found.chi2 / expected, 1, 1e-6);
      EXPECT_EQ(found.degreesOfFreedom, 3);
    }
  }
}

// A corridor along x: the scans say nothing of x, and a guess that is wrong by metres along it does
// not contradict them. Across it, 3 sigma of 1 cm and of 1 cm are 4.5 in one degree of freedom.
TEST(InnovationTest, ADirectionOfWhichTheScansSayNothingDoesNotCount)
{
  const Eigen::Matrix3d P = Eigen::Vector3d(1e-4, 1e-4, 1e-4).asDiagonal();
  const Eigen::Matrix3d H = Eigen::Vector3d(0, 1e4, 1e4).asDiagonal();
  const Innovation found = innovation({{5, 0.03, 0}, P}, {}, H, Eigen::Vector3d::Zero());
  EXPECT_EQ(found.degreesOfFreedom, 2);
  EXPECT_NEAR(found.chi2, 0.03 * 0.03 / 2e-4, 1e-9);
  EXPECT_TRUE(found.isAgreement());
}

TEST(InnovationTest, HeadingsOnBothSidesOfThePiCutAreNear)
{
  const Eigen::Matrix3d P = Eigen::Vector3d(1e-4, 1e-4, 1e-4).asDiagonal();
  const Innovation found = innovation({{0, 0, kPi - 0.001}, P}, {0, 0, -kPi + 0.001},
                                      1e4 * Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero());
  EXPECT_NEAR(found.chi2, 0.002 * 0.002 / 2e-4, 1e-9);
}

TEST(InnovationTest, AgreesWithin95PercentAndContradictsBeyond999PerMille)
{
  EXPECT_TRUE((Innovation{3.8, 1}.isAgreement()));
  EXPECT_FALSE((Innovation{3.9, 1}.isAgreement()));
  EXPECT_TRUE((Innovation{5.9, 2}.isAgreement()));
  EXPECT_TRUE((Innovation{7.8, 3}.isAgreement()));
  EXPECT_FALSE((Innovation{7.9, 3}.isAgreement()));
  EXPECT_FALSE((Innovation{10.8, 1}.isContradiction()));
  EXPECT_TRUE((Innovation{10.9, 1}.isContradiction()));
  EXPECT_TRUE((Innovation{13.9, 2}.isContradiction()));
  EXPECT_FALSE((Innovation{16.2, 3}.isContradiction()));
  EXPECT_TRUE((Innovation{16.3, 3}.isContradiction()));
}

TEST(InnovationTest, NothingInCommonIsNeither)
{
  EXPECT_FALSE(Innovation().isAgreement());
  EXPECT_FALSE(Innovation().isContradiction());
}
}  // namespace psmks
