/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/psm/PsmOrientation.h>
#include <tests/unit/psm/PsmScenes.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
using test::preparedScene;

double parabola(double x, double minimum) { return 3 * (x - minimum) * (x - minimum) + 0.2; }

TEST(PsmParabola, ItsMinimumIsFoundExactly)
{
  for (const double minimum : {0.0, 0.3, -0.45})
    EXPECT_NEAR(parabolaMinimum(parabola(-1, minimum), parabola(0, minimum), parabola(1, minimum)),
                minimum, 1e-12);
}

TEST(PsmParabola, WhereItIsNotLowestInTheMiddleTheMiddleStays)
{
  EXPECT_EQ(parabolaMinimum(1, 2, 3), 0);
  EXPECT_EQ(parabolaMinimum(2, 2, 3), 0);
  EXPECT_EQ(parabolaMinimum(2.00002, 2, 2.00005), 0) << "nearly flat";
  EXPECT_EQ(parabolaMinimum(std::numeric_limits<double>::infinity(), 2, 3), 0);
}

class PsmOrientationTest : public testing::Test
{
 protected:
  /** Searches the turn of a sensor that turned on the spot, from a projection without a turn. */
  std::optional<double> search_deg(double turn_deg, const BeamGrid& grid, double window_deg = 20)
  {
    reference_ = preparedScene(officeRoom(), {}, grid);
    return searchFor(preparedScene(officeRoom(), {0, 0, degToRad(turn_deg)}, grid), window_deg);
  }

  std::optional<double> searchFor(const PsmScan& current, double window_deg)
  {
    PsmProjection projection;
    projectPsmScan(current, {}, reference_.grid, projection);
    const auto turn_rad = findPsmTurn_rad(reference_, projection, degToRad(window_deg), errors_m_);
    return turn_rad ? std::optional<double>(radToDeg(*turn_rad)) : std::nullopt;
  }

  /** The best shift in rays. */
  long bestShift() const
  {
    const auto smallest = std::min_element(errors_m_.begin(), errors_m_.end());
    return smallest - errors_m_.begin() - static_cast<long>(errors_m_.size() / 2);
  }

  const BeamGrid open_ = BeamGrid::centered(kPi, 361);        // 0.5 deg
  const BeamGrid closed_ = BeamGrid::centered(2 * kPi, 720);  // 0.5 deg
  PsmScan reference_;
  std::vector<double> errors_m_;
};

TEST_F(PsmOrientationTest, ATurnByWholeRaysIsFoundOnTheRay)
{
  for (const BeamGrid& grid : {open_, closed_})
    for (const double turn_deg : {6.0, -14.5, 0.0, 20.0})
    {
      const auto found_deg = search_deg(turn_deg, grid);
      ASSERT_TRUE(found_deg);
      EXPECT_NEAR(*found_deg, turn_deg, 0.25);
      EXPECT_EQ(bestShift(), std::lround(turn_deg / 0.5));
      EXPECT_NEAR(*std::min_element(errors_m_.begin(), errors_m_.end()), 0, 1e-6);
    }
}

TEST_F(PsmOrientationTest, TheWindowLimitsTheReach)
{
  search_deg(6, open_, 5);
  EXPECT_EQ(errors_m_.size(), 21U);
  EXPECT_LT(std::abs(*search_deg(6, open_, 5)), 5.25);
  EXPECT_NEAR(*search_deg(6, open_, 7), 6, 0.25);
}

// The only object is behind the sensor, where the rays of a closed scan begin and end.
TEST_F(PsmOrientationTest, AClosedScanIsComparedAcrossItsSeam)
{
  const auto onlyBehind = [](Scan scan)
  {
    for (int i = 0; i < scan.grid.count(); ++i)
      if (std::abs(scan.grid.bearing_rad(i)) < degToRad(150))
        scan.range_m[static_cast<std::size_t>(i)] = 0;
    return test::prepared(scan);
  };
  reference_ = onlyBehind(castScan(officeRoom(), {}, closed_));
  const Pose2 turned{0, 0, degToRad(10)};
  ASSERT_TRUE(searchFor(onlyBehind(castScan(officeRoom(), turned, closed_)), 20));
  EXPECT_EQ(bestShift(), 20);
  EXPECT_NEAR(*std::min_element(errors_m_.begin(), errors_m_.end()), 0, 1e-6);
}

TEST_F(PsmOrientationTest, ScansThatShareNoBearingHaveNoTurn)
{
  reference_ = preparedScene({{{4, -9}, {4, -1}}}, {}, open_);
  EXPECT_FALSE(searchFor(preparedScene({{{4, 9}, {4, 3}}}, {}, open_), 20));
}
}  // namespace
}  // namespace psmks
