/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/psm/PsmTranslation.h>
#include <tests/unit/psm/PsmScenes.h>

namespace psmks
{
namespace
{
using test::prepared;

const Eigen::Vector2d kShift_m(0.12, -0.07);

class PsmTranslationTest : public testing::Test
{
 protected:
  /** A round wall at 5 m, and its projection as the linear model has it after a shift:
   *  d = cos b dx + sin b dy. */
  PsmTranslationTest()
  {
    Scan scan;
    scan.grid = BeamGrid::centered(kPi, 181);
    scan.range_m.assign(181, 5);
    reference_ = prepared(scan);
    projection_.tag.assign(181, PsmTag::Good);
    for (int i = 0; i < 181; ++i)
      projection_.range_m.push_back(5 - kShift_m.dot(scan.grid.direction(i)));
  }

  PsmTranslation solve(double weightScale_m = 0.7) const
  {
    return solvePsmTranslation(reference_, projection_, weightScale_m, options_);
  }

  double error_m(double weightScale_m) const
  {
    return (solve(weightScale_m).step_m - kShift_m).norm();
  }

  PsmOptions options_;
  PsmScan reference_;
  PsmProjection projection_;
};

TEST_F(PsmTranslationTest, APureShiftIsRecovered)
{
  const PsmTranslation result = solve();
  EXPECT_EQ(result.pairs, 181);
  EXPECT_TRUE(result.solvable);
  EXPECT_NEAR((result.step_m - kShift_m).norm(), 0, 1e-12);
}

TEST_F(PsmTranslationTest, AStrictWeightHoldsPairsThatDifferMuchInCheck)
{
  for (std::size_t i = 0; i < 40; ++i) projection_.range_m[i] -= 0.8;
  EXPECT_GT(error_m(10), 0.3);
  EXPECT_LT(error_m(0.7), 0.3);
  EXPECT_LT(error_m(0.1), 0.05);
}

TEST_F(PsmTranslationTest, PairsThatAreNotGoodOnBothSidesAreLeftOut)
{
  projection_.tag[10] = PsmTag::Occluded;
  projection_.tag[11] = PsmTag::Empty;
  reference_.tag[12] = PsmTag::BeyondRange;
  EXPECT_EQ(solve().pairs, 178);
  EXPECT_NEAR((solve().step_m - kShift_m).norm(), 0, 1e-12);
}

TEST_F(PsmTranslationTest, PairsFartherApartThanAllowedAreLeftOut)
{
  for (std::size_t i = 0; i < 40; ++i) projection_.range_m[i] -= 0.8;
  options_.maxPairDifference_m = 0.5;
  EXPECT_EQ(solve().pairs, 141);
  EXPECT_NEAR(error_m(10), 0, 1e-12);
}

TEST_F(PsmTranslationTest, ProjectedRangesOutsideTheScannersAreLeftOut)
{
  options_.maxPairDifference_m = 100;
  projection_.range_m[10] = 0.05;
  projection_.range_m[11] = 40;
  reference_.maxRange_m = 30;
  EXPECT_EQ(solve().pairs, 179);
  options_.minProjectedRange_m = 0.01;
  EXPECT_EQ(solve().pairs, 180);
}

TEST_F(PsmTranslationTest, OneBearingDoesNotFixAPosition)
{
  projection_.tag.assign(181, PsmTag::Empty);
  projection_.tag[90] = PsmTag::Good;
  EXPECT_EQ(solve().pairs, 1);
  EXPECT_FALSE(solve().solvable);
  EXPECT_EQ(solve().step_m.norm(), 0);
}
}  // namespace
}  // namespace psmks
