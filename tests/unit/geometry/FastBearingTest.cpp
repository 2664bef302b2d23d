/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/geometry/Angle.h>
#include <psmks/geometry/FastBearing.h>

namespace psmks
{
TEST(FastBearing, IsAtan2Within12Microradians)
{
  constexpr int kDirections = 100000;
  double worst_rad = 0;
  for (int i = 0; i < kDirections; ++i)
  {
    const double bearing_rad = kPi * (2.0 * (i + 0.5) / kDirections - 1);
    const auto x = static_cast<float>(3 * std::cos(bearing_rad));
    const auto y = static_cast<float>(3 * std::sin(bearing_rad));
    const double error_rad = wrapAngle(fastBearing_rad(y, x) - std::atan2(y, x));
    worst_rad = std::max(worst_rad, std::abs(error_rad));
  }
  EXPECT_LT(worst_rad, 1.2e-5);
}

TEST(FastBearing, KnowsTheAxesAndTheOrigin)
{
  EXPECT_FLOAT_EQ(fastBearing_rad(0, 1), 0);
  EXPECT_FLOAT_EQ(fastBearing_rad(2, 0), static_cast<float>(kPi / 2));
  EXPECT_FLOAT_EQ(fastBearing_rad(-2, 0), static_cast<float>(-kPi / 2));
  EXPECT_FLOAT_EQ(fastBearing_rad(0, -1), static_cast<float>(kPi));
  EXPECT_EQ(fastBearing_rad(0, 0), 0);
}

TEST(FastBearing, DependsOnTheDirectionOnly)
{
  for (const float scale : {1e-4f, 1.0f, 1e6f})
    EXPECT_NEAR(fastBearing_rad(0.3f * scale, -0.7f * scale), fastBearing_rad(0.3f, -0.7f), 1e-6);
}
}  // namespace psmks
