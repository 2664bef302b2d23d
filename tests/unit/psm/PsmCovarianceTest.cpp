/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/psm/PsmCorridor.h>
#include <psmks/psm/PsmCovariance.h>
#include <psmks/psm/PsmMatchError.h>
#include <tests/unit/psm/PsmScenes.h>

#include <cmath>

namespace psmks
{
namespace
{
using test::drawnScan;
using test::prepared;
using test::preparedScene;

const BeamGrid kGrid = BeamGrid::centered(kPi, 361);

PsmScan noisy(const std::vector<Wall>& walls, double heading_deg)
{
  std::mt19937 rng(1);
  const Scan scan = castScan(walls, {0, 0.2, degToRad(heading_deg)}, kGrid, 8, 0.01, rng);
  return prepared(scan, PsmOptions());
}

// The corridor is parallel to the x axis of the world. A sensor that is turned by an angle sees it
// at the opposite angle.
TEST(PsmCorridor, ACorridorIsFoundWithItsDirection)
{
  for (const double heading_deg : {0.0, 3.0, -35.0, 80.0})
  {
    const auto direction_rad = corridorDirection_rad(noisy(corridor(), heading_deg), PsmOptions());
    ASSERT_TRUE(direction_rad) << heading_deg;
    const double off_rad = std::remainder(*direction_rad + degToRad(heading_deg), kPi);
    EXPECT_NEAR(radToDeg(off_rad), 0, 1.5) << heading_deg;
  }
}

TEST(PsmCorridor, ARoomIsNone)
{
  for (const double heading_deg : {0.0, 30.0, -75.0})
    EXPECT_FALSE(corridorDirection_rad(noisy(officeRoom(), heading_deg), PsmOptions()));
}

TEST(PsmCorridor, TheSpreadAndTheChordAreOptions)
{
  PsmOptions options;
  options.corridorSpread_rad = degToRad(60);
  EXPECT_TRUE(corridorDirection_rad(noisy(officeRoom(), 0), options));
  options = PsmOptions();
  options.chordArc_rad = degToRad(170);
  EXPECT_FALSE(corridorDirection_rad(noisy(corridor(), 0), options)) << "no surface is that wide";
}

TEST(PsmCorridor, NothingIsSaidOfNothing)
{
  EXPECT_FALSE(corridorDirection_rad(prepared(Scan()), PsmOptions()));
  EXPECT_FALSE(corridorDirection_rad(prepared(drawnScan({2, 2})), PsmOptions()));
}

TEST(PsmCovariance, InARoomItIsTheSameInEveryDirection)
{
  const PsmOptions options;
  const Eigen::Matrix3d covariance = psmCovariance(noisy(officeRoom(), 0), 0.01, options);
  const Eigen::Vector3d variances(0.04, 0.04, std::pow(degToRad(4), 2));
  EXPECT_TRUE(covariance.isApprox(Eigen::Matrix3d(variances.asDiagonal())));
}

TEST(PsmCovariance, ItGrowsWithTheErrorIndexBeyondTheOffset)
{
  const PsmOptions options;
  const PsmScan room = noisy(officeRoom(), 0);
  const double atBest = psmCovariance(room, 0, options)(0, 0);
  EXPECT_EQ(psmCovariance(room, 0.06, options)(0, 0), atBest);
  EXPECT_NEAR(psmCovariance(room, 0.08, options)(0, 0), 3 * atBest, 1e-9);
  EXPECT_NEAR(psmCovariance(room, 0.08, options)(2, 2), 3 * std::pow(degToRad(4), 2), 1e-9);
}

TEST(PsmCovariance, InACorridorItIsLargeAlongIt)
{
  const Eigen::Matrix3d covariance = psmCovariance(noisy(corridor(), -35), 0, PsmOptions());
  const Eigen::Vector2d along(std::cos(degToRad(35)), std::sin(degToRad(35)));
  const Eigen::Vector2d across(-along.y(), along.x());
  const Eigen::Matrix2d position = covariance.topLeftCorner<2, 2>();
  EXPECT_NEAR(std::sqrt(along.dot(position * along)), 4, 0.05);
  EXPECT_NEAR(std::sqrt(across.dot(position * across)), 0.3, 0.05);
}

TEST(PsmMatchError, RangesTellByHowMuchTheyDiffer)
{
  const PsmScan reference = prepared(drawnScan({2, 2, 2, 2, 2}));
  PsmProjection projection;
  projection.range_m = {2.1, 1.9, 2, 2.6, 2};
  projection.tag = {PsmTag::Good, PsmTag::Good, PsmTag::Good, PsmTag::Good, PsmTag::Occluded};
  EXPECT_NEAR(rangeErrorIndex_m(reference, projection, 1), 0.2 / 3, 1e-12);
  EXPECT_NEAR(rangeErrorIndex_m(reference, projection, 2), 0.8 / 4, 1e-12);
  projection.tag.assign(5, PsmTag::Empty);
  EXPECT_TRUE(std::isinf(rangeErrorIndex_m(reference, projection, 1)));
}

// One scan has a point that is 3 m from all points of the other: the larger of both means counts.
TEST(PsmMatchError, PointsTellByHowFarTheNearestIs)
{
  const PsmScan reference = prepared(drawnScan({2, 2, 2}));
  const PsmScan current = prepared(drawnScan({2, 5, 2}));
  EXPECT_NEAR(pointErrorIndex_m(reference, reference, {}), 0, 1e-12);
  EXPECT_NEAR(pointErrorIndex_m(reference, current, {}), 1, 1e-9);
  EXPECT_NEAR(pointErrorIndex_m(reference, reference, {0.1, 0, 0}), 0.1, 1e-9);
  EXPECT_TRUE(std::isinf(pointErrorIndex_m(prepared(Scan()), reference, {})));
}
}  // namespace
}  // namespace psmks
