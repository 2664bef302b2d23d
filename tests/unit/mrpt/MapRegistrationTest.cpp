/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/mrpt/MapRegistration.h>
#include <tests/support/PoseMatcher.h>
#include <tests/support/RandomNumbers.h>
#include <tests/support/Scenes.h>

#include <Eigen/LU>
#include <cmath>

namespace psmks::test
{
namespace
{
constexpr double kSigma_m = 0.01;

/** The points of a scan of walls, in the frame of the sensor. */
std::vector<Eigen::Vector2d> scanPoints(const std::vector<Wall>& walls, const Pose2& T_world_sensor,
                                        RandomNumbers& random)
{
  const BeamGrid grid = BeamGrid::centered(2 * kPi, 360);
  const Scan scan = castScan(walls, T_world_sensor, grid);
  std::vector<Eigen::Vector2d> points_m;
  for (int ray = 0; ray < grid.count(); ++ray)
    points_m.push_back((scan.range_m[static_cast<std::size_t>(ray)] + random.normal(kSigma_m)) *
                       grid.direction(ray));
  return points_m;
}

/** The map of scans from some places of a room. */
void addScans(SurfaceField& field, const std::vector<Wall>& walls,
              const std::vector<Pose2>& T_world_sensors, RandomNumbers& random)
{
  for (const Pose2& T_world_sensor : T_world_sensors)
    for (const Eigen::Vector2d& p : scanPoints(walls, T_world_sensor, random))
      field.add(T_world_sensor * p);
}

const Pose2 kPlace{0.6, -0.4, degToRad(25)};
const Pose2 kStart{0.75, -0.3, degToRad(31)};  // 18 cm and 6 degrees off
}  // namespace

TEST(MapRegistration, FindsThePoseInAMapOfManyScans)
{
  RandomNumbers random(4);
  SCOPED_TRACE(random.seedText());
  SurfaceField field;
  addScans(field, officeRoom(), {{0, 0, 0}, {1, 0.5, 1}, {-1, 0.8, 2}}, random);
  const auto points_m = scanPoints(officeRoom(), kPlace, random);
  MapRegistration registration(points_m, kSigma_m, field, {0, 0}, {});
  const Registration found = registration.refine(kStart, std::nullopt, 0.5);
  EXPECT_TRUE(isNearly(found.T_map_points, kPlace, 0.005, degToRad(0.1)));
  EXPECT_TRUE(found.converged);
  EXPECT_GT(found.explainedShare(), 0.9);
  EXPECT_LT(found.iterations, RegistrationOptions().maxIterations);
}

//  Errors of the map doubled its walls: 4 cm aside. The pose is that between both.
TEST(MapRegistration, StandsBetweenDoubledWallsAndKnowsThemToTheirThickness)
{
  RandomNumbers random(5);
  SCOPED_TRACE(random.seedText());
  SurfaceField sharp, doubled;
  const std::vector<Pose2> places{{0, 0, 0}, {1, 0.5, 1}};
  addScans(sharp, officeRoom(), places, random);
  for (const double aside_m : {-0.02, 0.02})
    for (const Pose2& place : places)
      for (const Eigen::Vector2d& p : scanPoints(officeRoom(), place, random))
        doubled.add(place * p + Eigen::Vector2d(aside_m, aside_m));

  const auto points_m = scanPoints(officeRoom(), kPlace, random);
  const auto inSharp =
      MapRegistration(points_m, kSigma_m, sharp, {0, 0}, {}).refine(kStart, std::nullopt, 0.5);
  const auto inDoubled =
      MapRegistration(points_m, kSigma_m, doubled, {0, 0}, {}).refine(kStart, std::nullopt, 0.5);
  EXPECT_TRUE(isNearly(inDoubled.T_map_points, kPlace, 0.01, degToRad(0.2)));
  EXPECT_GT(inDoubled.explainedShare(), 0.9);
  EXPECT_LT(inDoubled.information(0, 0), 0.5 * inSharp.information(0, 0));
}

TEST(MapRegistration, MeansTheSameFromAnyOrigin)
{
  RandomNumbers random(6);
  SCOPED_TRACE(random.seedText());
  const auto map = scanPoints(officeRoom(), {0, 0, 0}, random);
  const auto points_m = scanPoints(officeRoom(), kPlace, random);
  const Eigen::Vector2d origin_m(70, -35);  // of the field, in the frame of the map
  SurfaceField field;
  for (const Eigen::Vector2d& p : map) field.add(p);
  const auto here =
      MapRegistration(points_m, kSigma_m, field, {0, 0}, {}).refine(kStart, std::nullopt, 0.5);
  const Pose2 start{kStart.x_m + origin_m.x(), kStart.y_m + origin_m.y(), kStart.phi_rad};
  const auto there =
      MapRegistration(points_m, kSigma_m, field, origin_m, {}).refine(start, std::nullopt, 0.5);
  EXPECT_NEAR(there.T_map_points.x_m - origin_m.x(), here.T_map_points.x_m, 1e-9);
  EXPECT_NEAR(there.T_map_points.y_m - origin_m.y(), here.T_map_points.y_m, 1e-9);
}

TEST(MapRegistration, LetsAPriorPull)
{
  RandomNumbers random(7);
  SCOPED_TRACE(random.seedText());
  SurfaceField field;
  addScans(field, officeRoom(), {{0, 0, 0}}, random);
  const auto points_m = scanPoints(officeRoom(), kPlace, random);
  MapRegistration registration(points_m, kSigma_m, field, {0, 0}, {});
  const Eigen::Matrix3d sure = 1e-10 * Eigen::Matrix3d::Identity();
  const Pose2 near{kPlace.x_m + 0.02, kPlace.y_m, kPlace.phi_rad};
  const Registration held = registration.refine(near, MapRegistration::Prior{near, sure}, 0.1);
  EXPECT_TRUE(isNearly(held.T_map_points, near, 1e-3, degToRad(0.01)));
  const Registration freed = registration.refine(near, std::nullopt, 0.1);
  EXPECT_NEAR(freed.information(0, 0) / held.information(0, 0), 1, 0.5);  // the prior's is left out
}

TEST(MapRegistration, StaysWhereNothingIsNear)
{
  RandomNumbers random(8);
  SCOPED_TRACE(random.seedText());
  SurfaceField field;
  addScans(field, officeRoom(), {{0, 0, 0}}, random);
  const auto points_m = scanPoints(officeRoom(), kPlace, random);
  MapRegistration registration(points_m, kSigma_m, field, {0, 0}, {});
  const Registration lost = registration.refine({500, 0, 0}, std::nullopt, 0.5);
  EXPECT_TRUE(isNearly(lost.T_map_points, {500, 0, 0}, 1e-12, 1e-12));
  EXPECT_EQ(lost.covered, 0);
  EXPECT_EQ(lost.explainedShare(), 0);
  EXPECT_TRUE(lost.information.isZero());
}

TEST(MapRegistration, IsSteeredByItsOptions)
{
  RandomNumbers random(9);
  SCOPED_TRACE(random.seedText());
  SurfaceField field;
  addScans(field, officeRoom(), {{0, 0, 0}}, random);
  const auto points_m = scanPoints(officeRoom(), kPlace, random);
  const auto refined = [&](const RegistrationOptions& options)
  {
    return MapRegistration(points_m, kSigma_m, field, {0, 0}, options)
        .refine(kStart, std::nullopt, 0.5);
  };
  const Registration usual = refined({});
  RegistrationOptions few, finer, slow, coarseStop;
  few.maxIterations = 2;
  EXPECT_EQ(refined(few).iterations, 2);
  EXPECT_FALSE(refined(few).converged);
  finer.smallestThresholdDist = 0.005;
  EXPECT_GT(refined(finer).iterations, usual.iterations);
  slow.ALFA = 0.9, slow.maxIterations = 100;
  EXPECT_GT(refined(slow).iterations, usual.iterations);
  coarseStop.minAbsStep_trans = 0.01, coarseStop.minAbsStep_rot = degToRad(1);
  EXPECT_LT(refined(coarseStop).iterations, usual.iterations);
}

//  NEES of 60 registrations of a scan to a map of one scan: 3 where the information is right.
TEST(MapRegistration, StatesItsErrors)
{
  RandomNumbers random(10);
  SCOPED_TRACE(random.seedText());
  constexpr int kTimes = 60;
  double nees = 0;
  for (int i = 0; i < kTimes; ++i)
  {
    SurfaceField field;
    const Pose2 place{random.uniform(-1, 1), random.uniform(-0.8, 0.8), random.uniform(-3, 3)};
    addScans(field, officeRoom(), {{0, 0, 0}}, random);
    const auto points_m = scanPoints(officeRoom(), place, random);
    const auto found =
        MapRegistration(points_m, kSigma_m, field, {0, 0}, {}).refine(place, std::nullopt, 0.2);
    const Eigen::Vector3d error(found.T_map_points.x_m - place.x_m,
                                found.T_map_points.y_m - place.y_m,
                                wrapAngle(found.T_map_points.phi_rad - place.phi_rad));
    nees += error.dot(found.information * error) / kTimes;
  }
  EXPECT_GT(nees, 1);
  EXPECT_LT(nees, 6);
}
}  // namespace psmks::test
