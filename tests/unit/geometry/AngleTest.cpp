/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/geometry/Angle.h>
#include <tests/support/RandomNumbers.h>

namespace psmks
{
TEST(Angle, TheIntervalIsOpenAtMinusPiAndClosedAtPi)
{
  EXPECT_EQ(wrapAngle(kPi), kPi);
  EXPECT_EQ(wrapAngle(-kPi), kPi);
  EXPECT_DOUBLE_EQ(wrapAngle(3 * kPi), kPi);
  EXPECT_DOUBLE_EQ(wrapAngle(-3 * kPi), kPi);
}

TEST(Angle, AnAngleInsideTheIntervalIsReturnedUnchanged)
{
  for (const double angle_rad : {0.0, 1e-300, -3.14, 3.14, 0.1})
    EXPECT_EQ(wrapAngle(angle_rad), angle_rad);
}

TEST(Angle, WrappingKeepsTheDirection)
{
  test::RandomNumbers random(11);
  SCOPED_TRACE(random.seedText());
  for (int n = 0; n < 1000; ++n)
  {
    const double angle_rad = random.uniform(-100, 100);
    const double wrapped_rad = wrapAngle(angle_rad);
    EXPECT_GT(wrapped_rad, -kPi);
    EXPECT_LE(wrapped_rad, kPi);
    EXPECT_NEAR(std::cos(wrapped_rad), std::cos(angle_rad), 1e-12) << angle_rad;
    EXPECT_NEAR(std::sin(wrapped_rad), std::sin(angle_rad), 1e-12) << angle_rad;
  }
}

TEST(Angle, AnAngleThatIsNotFiniteStaysSo)
{
  EXPECT_FALSE(std::isfinite(wrapAngle(std::nan(""))));
  EXPECT_FALSE(std::isfinite(wrapAngle(INFINITY)));
}

TEST(Angle, DegreesAndRadians)
{
  EXPECT_DOUBLE_EQ(degToRad(180), kPi);
  EXPECT_DOUBLE_EQ(degToRad(-90), -kPi / 2);
  EXPECT_DOUBLE_EQ(radToDeg(kPi / 6), 30);
}
}  // namespace psmks
