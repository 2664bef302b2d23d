/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/geometry/Angle.h>
#include <psmks/motion/OdometryQuality.h>

namespace psmks
{
namespace
{
/** A motion of a metre that is stated to be off by 10 cm and 5 degrees. */
UncertainPose measured()
{
  const double sigma_rad = degToRad(5);
  return {{1, 0, 0}, Eigen::Vector3d(0.01, 0.01, sigma_rad * sigma_rad).asDiagonal()};
}

/** The quality after motions that were all off by so many standard deviations in every direction.
 */
double factorAfter(int motions, double sigmas)
{
  OdometryQuality quality;
  const Pose2 matched{1 + 0.1 * sigmas, 0.1 * sigmas, degToRad(5) * sigmas};
  for (int i = 0; i < motions; ++i) quality.learn(measured(), matched);
  return quality.varianceFactor();
}
}  // namespace

TEST(OdometryQuality, IsAsStatedBeforeTheFirstMotion) { EXPECT_EQ(factorAfter(0, 0), 1); }

TEST(OdometryQuality, BecomesThatOfTheErrorsSeen)
{
  EXPECT_NEAR(factorAfter(10, 0.5), (10 + 10 * 0.25) / 20, 1e-12);
  EXPECT_NEAR(factorAfter(10000, 0.5), 0.25, 0.01);
}

TEST(OdometryQuality, IsNeverWorseThanStated) { EXPECT_EQ(factorAfter(1000, 2), 1); }

TEST(OdometryQuality, IsNotRuinedByOneMatchThatIsWrong)
{
  OdometryQuality quality;
  for (int i = 0; i < 1000; ++i) quality.learn(measured(), measured().pose);
  quality.learn(measured(), {100, 0, degToRad(180)});
  EXPECT_LT(quality.varianceFactor(), 0.02);
}
}  // namespace psmks
