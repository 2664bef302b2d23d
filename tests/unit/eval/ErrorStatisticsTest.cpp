/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/eval/ErrorStatistics.h>
#include <psmks/geometry/Angle.h>

#include <cmath>

namespace psmks
{
namespace
{
TEST(ErrorStatisticsTest, AreThoseThatOneCanReckonByHand)
{
  const ErrorStatistics s = errorStatistics(std::vector<double>{4, 0, 2, 0, 4});
  EXPECT_NEAR(s.mean, 2, 1e-12);
  EXPECT_NEAR(s.std, std::sqrt(16.0 / 5), 1e-12);
  EXPECT_NEAR(s.rms, std::sqrt(36.0 / 5), 1e-12);
  EXPECT_NEAR(s.median, 2, 1e-12);
  EXPECT_NEAR(s.p95, 4, 1e-12);
  EXPECT_NEAR(s.max, 4, 1e-12);
}

TEST(ErrorStatisticsTest, WithoutErrorsNothingIsKnown)
{
  const PairErrorStatistics s = errorStatistics(std::vector<PairError>{}, kSuccessLimit);
  EXPECT_EQ(s.count, 0u);
  EXPECT_TRUE(std::isnan(s.translation_m.mean));
  EXPECT_TRUE(std::isnan(s.rotation_rad.max));
  EXPECT_TRUE(std::isnan(s.withinLimit));
}

TEST(ErrorStatisticsTest, AnErrorIsWithinTheLimitWhereBothItsPartsAre)
{
  const std::vector<PairError> errors{
      {0.1, degToRad(1)}, {0.2, degToRad(1)}, {0.1, degToRad(3)}, {0.1, degToRad(1.9)}};
  const PairErrorStatistics s = errorStatistics(errors, {0.15, degToRad(2)});
  EXPECT_EQ(s.count, 4u);
  EXPECT_NEAR(s.withinLimit, 0.5, 1e-12);
  EXPECT_NEAR(s.translation_m.max, 0.2, 1e-12);
  EXPECT_NEAR(s.rotation_rad.max, degToRad(3), 1e-12);
  EXPECT_NEAR(s.squaredTranslation_m2.mean, (3 * 0.01 + 0.04) / 4, 1e-12);
}
}  // namespace
}  // namespace psmks
