/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/sim/PoseBound.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "tests/support/RandomNumbers.h"

namespace psmks
{
namespace
{
constexpr double kSigma_m = 0.01;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/** Rays all round, so that both scans see every object. */
const BeamGrid kAllRound = BeamGrid::centered(2 * kPi, 360);

//   +-----------------+ 4     walls 0 to 3: the room; walls 4 to 7: the box; object 8: the column,
//   |     +-+         |       0.3 m in radius
//   | r   +-+         |
//   |   c        ( )  |       r = reference, c = current
//   +-----------------+ 0
//   0     3 4     6   8
struct Scene
{
  std::vector<World::Wall> walls;
  std::vector<World::Circle> circles;

  World world() const
  {
    World world(walls);
    for (const World::Circle& circle : circles) world.addArc(circle, 0, 2 * kPi, 8);
    return world;
  }
};

const Pose2 kReference{1, 2, 0.4}, kCurrent{1.7, 1.2, -0.3};

Scene room()
{
  World walls;
  walls.addBox({4, 2}, {8, 4});
  walls.addBox({3.5, 2.5}, {1, 1}, 0.2);
  return {walls.walls(), {{{6, 1.2}, 0.3}}};
}

/** Two walls far longer than the laser can see. */
Scene corridor() { return {{{{-50, 0}, {50, 0}}, {{-50, 2}, {50, 2}}}, {}}; }

double circleRange_m(const World::Circle& circle, const Eigen::Vector2d& o,
                     const Eigen::Vector2d& e)
{
  const double ahead_m = e.dot(circle.centre_m - o);
  const double aside2_m2 = (circle.centre_m - o).squaredNorm() - ahead_m * ahead_m;
  const double inside_m2 = circle.radius_m * circle.radius_m - aside2_m2;
  return inside_m2 > 0 && ahead_m > 0 ? ahead_m - std::sqrt(inside_m2) : kInfinity;
}

SimulatedScan exactScan(const Scene& scene, const Pose2& T_world_sensor, double maxRange_m = 30)
{
  SimulatedScan exact;
  exact.scan.grid = kAllRound;
  exact.scan.maxRange_m = maxRange_m;
  const World walls(scene.walls);
  for (int ray = 0; ray < kAllRound.count(); ++ray)
  {
    const Eigen::Vector2d e = T_world_sensor.rotation() * kAllRound.direction(ray);
    Hit hit = walls.cast(T_world_sensor.translation(), e, maxRange_m, 0);
    for (std::size_t c = 0; c < scene.circles.size(); ++c)
    {
      const double range_m = circleRange_m(scene.circles[c], T_world_sensor.translation(), e);
      if (range_m < hit.range_m) hit = {range_m, static_cast<int>(scene.walls.size() + c)};
    }
    exact.scan.range_m.push_back(hit.object == Hit::kNothing ? 0 : hit.range_m);
    exact.objectOfRay.push_back(hit.object);
    exact.noise_m.push_back(0);
  }
  return exact;
}

SimulatedScan withNoise(SimulatedScan scan, test::RandomNumbers& random)
{
  for (std::size_t ray = 0; ray < scan.objectOfRay.size(); ++ray)
  {
    if (scan.objectOfRay[ray] == Hit::kNothing) continue;
    scan.noise_m[ray] = random.normal(kSigma_m);
    scan.scan.range_m[ray] += scan.noise_m[ray];
  }
  return scan;
}

SimulatedScan seenOnly(SimulatedScan scan, const std::function<bool(int ray, int object)>& kept)
{
  for (std::size_t ray = 0; ray < scan.objectOfRay.size(); ++ray)
    if (!kept(static_cast<int>(ray), scan.objectOfRay[ray])) scan.objectOfRay[ray] = Hit::kNothing;
  return scan;
}

// ---- the same by brute force
// ----------------------------------------------------------------------

/** Computes the bound in another way. The state is x, y, phi of T_ref_cur, then (d, alpha) of each
 * wall and (centre, radius) of each circle in the frame of the reference. Ranges come from
 * trigonometry, their derivatives from differences, and the least squares are solved in one dense
 * matrix. */
class BruteForce
{
 public:
  BruteForce(const Scene& scene, const SimulatedScan& reference, const SimulatedScan& current)
      : walls_(scene.walls.size())
  {
    const Pose2 T_ref_world = kReference.inverse(), T_ref_cur = T_ref_world * kCurrent;
    parameters_ = {T_ref_cur.x_m, T_ref_cur.y_m, T_ref_cur.phi_rad};
    for (const World::Wall& wall : scene.walls)
    {
      const Eigen::Vector2d a = T_ref_world * wall.a, b = T_ref_world * wall.b;
      const double alpha = std::atan2(b.x() - a.x(), -(b.y() - a.y()));
      append({a.x() * std::cos(alpha) + a.y() * std::sin(alpha), alpha});
    }
    for (const World::Circle& circle : scene.circles)
    {
      const Eigen::Vector2d c = T_ref_world * circle.centre_m;
      append({c.x(), c.y(), circle.radius_m});
    }
    addRays(reference, false);
    addRays(current, true);
  }

  /** The largest difference between a range of the model and the one that was cast. */
  double worstModelError_m() const { return worstModelError_m_; }

  /** The marginal information of the pose, after eliminating the objects. */
  PoseBound bound() const
  {
    const auto rows = static_cast<Eigen::Index>(rows_.size());
    Eigen::MatrixXd pose(rows, 3), objects(rows, static_cast<Eigen::Index>(parameters_.size()) - 3);
    Eigen::VectorXd noise(rows);
    for (Eigen::Index i = 0; i < rows; ++i)
    {
      const Eigen::VectorXd& row = rows_[static_cast<std::size_t>(i)];
      pose.row(i) = row.head<3>();
      objects.row(i) = row.tail(row.size() - 3);
      noise(i) = noise_m_[static_cast<std::size_t>(i)];
    }
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> fit(objects);
    const Eigen::MatrixXd left = pose - objects * fit.solve(pose);
    const double information = 1 / (kSigma_m * kSigma_m);
    return {information * left.transpose() * left, information * left.transpose() * noise};
  }

 private:
  void append(const std::vector<double>& parameters)
  {
    parameters_.insert(parameters_.end(), parameters.begin(), parameters.end());
  }

  double range_m(bool fromCurrent, double bearing_rad, int object) const
  {
    const Pose2 T_ref_sensor =
        fromCurrent ? Pose2{parameters_[0], parameters_[1], parameters_[2]} : Pose2{};
    const double heading_rad = T_ref_sensor.phi_rad + bearing_rad;
    const Eigen::Vector2d o = T_ref_sensor.translation();
    const Eigen::Vector2d e(std::cos(heading_rad), std::sin(heading_rad));
    const auto index = static_cast<std::size_t>(object);
    const double* p = &parameters_[3 + 2 * std::min(index, walls_)];
    if (index >= walls_)
      return circleRange_m(
          {{p[3 * (index - walls_)], p[3 * (index - walls_) + 1]}, p[3 * (index - walls_) + 2]}, o,
          e);
    const Eigen::Vector2d n(std::cos(p[1]), std::sin(p[1]));
    return (p[0] - n.dot(o)) / n.dot(e);
  }

  void addRays(const SimulatedScan& scan, bool fromCurrent)
  {
    constexpr double kStep = 1e-6;
    for (int ray = 0; ray < kAllRound.count(); ++ray)
    {
      const auto i = static_cast<std::size_t>(ray);
      if (scan.objectOfRay[i] == Hit::kNothing) continue;
      const auto range = [&]
      { return range_m(fromCurrent, kAllRound.bearing_rad(ray), scan.objectOfRay[i]); };
      worstModelError_m_ =
          std::max(worstModelError_m_, std::abs(range() - scan.scan.range_m[i] + scan.noise_m[i]));
      Eigen::VectorXd row(parameters_.size());
      for (std::size_t k = 0; k < parameters_.size(); ++k)
      {
        const double at = parameters_[k];
        parameters_[k] = at + kStep;
        const double above_m = range();
        parameters_[k] = at - kStep;
        row(static_cast<Eigen::Index>(k)) = (above_m - range()) / (2 * kStep);
        parameters_[k] = at;
      }
      rows_.push_back(row);
      noise_m_.push_back(scan.noise_m[i]);
    }
  }

  std::size_t walls_;
  std::vector<double> parameters_, noise_m_;
  std::vector<Eigen::VectorXd> rows_;
  double worstModelError_m_ = 0;
};

PoseBound boundOf(const Scene& scene, const SimulatedScan& reference, const SimulatedScan& current)
{
  return poseBound(scene.world(), kReference, reference, kCurrent, current, {kSigma_m});
}

void expectNearly(const PoseBound& actual, const PoseBound& expected)
{
  EXPECT_TRUE(actual.information.isApprox(expected.information, 1e-6))
      << actual.information << "\nis not nearly\n"
      << expected.information;
  EXPECT_TRUE(actual.pull.isApprox(expected.pull, 1e-6))
      << actual.pull.transpose() << " is not nearly " << expected.pull.transpose();
}

Eigen::Vector3d errorWithoutPrior(const PoseBound& bound)
{
  return bound.information.ldlt().solve(bound.pull);
}
}  // namespace

TEST(PoseBound, AgreesWithDenseLeastSquaresOverNumericDerivatives)
{
  test::RandomNumbers random(1);
  const SimulatedScan reference = withNoise(exactScan(room(), kReference), random);
  const SimulatedScan current = withNoise(exactScan(room(), kCurrent), random);
  for (const SimulatedScan& scan : {reference, current})
    ASSERT_GT(std::count(scan.objectOfRay.begin(), scan.objectOfRay.end(), 8), 4);

  const BruteForce brute(room(), reference, current);
  ASSERT_LT(brute.worstModelError_m(), 1e-9);
  expectNearly(boundOf(room(), reference, current), brute.bound());
}

TEST(PoseBound, WhatOneScanAloneSeesSaysNothing)
{
  test::RandomNumbers random(2);
  const SimulatedScan reference = withNoise(exactScan(room(), kReference), random);
  const SimulatedScan current = withNoise(exactScan(room(), kCurrent), random);
  const auto noBox = [](int, int object) { return object < 4; };
  const auto all = [](int, int) { return true; };
  const PoseBound oneSided = boundOf(room(), seenOnly(reference, noBox), seenOnly(current, all));
  expectNearly(oneSided, boundOf(room(), seenOnly(reference, noBox), seenOnly(current, noBox)));
  expectNearly(oneSided, BruteForce(room(), seenOnly(reference, noBox), current).bound());
}

TEST(PoseBound, AnObjectCountsWithOneRayMoreThanItHasUnknowns)
{
  const auto rays = [](int object, int count)
  {
    return [object, count, seen = 0](int, int met) mutable
    { return met == object && seen++ < count; };
  };
  const auto informationWith = [&](int object, int ofReference, int ofCurrent)
  {
    const SimulatedScan reference = exactScan(room(), kReference);
    const SimulatedScan current = exactScan(room(), kCurrent);
    return boundOf(room(), seenOnly(reference, rays(object, ofReference)),
                   seenOnly(current, rays(object, ofCurrent)))
        .information.norm();
  };
  constexpr int kWall = 2, kColumn = 8;
  EXPECT_EQ(informationWith(kWall, 1, 1), 0);
  EXPECT_GT(informationWith(kWall, 2, 1), 1);
  EXPECT_GT(informationWith(kWall, 1, 2), 1);
  EXPECT_EQ(informationWith(kWall, 3, 0), 0);
  EXPECT_EQ(informationWith(kColumn, 2, 1), 0);
  EXPECT_GT(informationWith(kColumn, 2, 2), 1);
}

TEST(PoseBound, LonePointsAndMovingObjectsSayNothing)
{
  const PoseBound walls =
      boundOf(room(), exactScan(room(), kReference), exactScan(room(), kCurrent));
  const auto renamed = [](SimulatedScan scan, int from, int to)
  {
    std::replace(scan.objectOfRay.begin(), scan.objectOfRay.end(), from, to);
    return scan;
  };
  for (const int object : {World::kIsolatedPoint, 9})
  {
    const auto withoutColumn = [](int, int met) { return met != 8; };
    const PoseBound ignored = boundOf(room(), renamed(exactScan(room(), kReference), 8, object),
                                      renamed(exactScan(room(), kCurrent), 8, object));
    expectNearly(ignored, boundOf(room(), seenOnly(exactScan(room(), kReference), withoutColumn),
                                  seenOnly(exactScan(room(), kCurrent), withoutColumn)));
    EXPECT_GT(walls.information(0, 0), 1.001 * ignored.information(0, 0));
  }
}

TEST(PoseBound, AMixedPixelIsLeftOut)
{
  SimulatedScan current = exactScan(room(), kCurrent);
  current.noise_m[100] = 0.5;
  current.scan.range_m[100] += 0.5;
  EXPECT_EQ(boundOf(room(), exactScan(room(), kReference), current).pull.norm(), 0);
}

TEST(PoseBound, ExactScansLeaveNoError)
{
  const PoseBound bound =
      boundOf(room(), exactScan(room(), kReference), exactScan(room(), kCurrent));
  EXPECT_EQ(bound.pull.norm(), 0);
  EXPECT_GT(bound.information.diagonal().minCoeff(), 1e5);
}

// The error of a range is that of the distance to the wall over the cosine of incidence. A range to
// a wall seen at an angle therefore determines the distance better, not worse.
TEST(PoseBound, RangesAtASlantKnowTheDistanceBetter)
{
  const auto acrossSigma_m = [](double bearing_rad)
  {
    const auto near = [bearing_rad](int ray, int)
    { return std::abs(std::abs(kAllRound.bearing_rad(ray)) - bearing_rad) < degToRad(10); };
    const Pose2 middle{0, 1, 0};
    const SimulatedScan scan = seenOnly(exactScan(corridor(), middle, 8), near);
    const PoseBound bound = poseBound(corridor().world(), middle, scan, middle, scan, {kSigma_m});
    return 1 / std::sqrt(bound.information(1, 1));
  };
  EXPECT_LT(acrossSigma_m(degToRad(45)), 0.8 * acrossSigma_m(degToRad(90)));
}

TEST(PoseBound, ABareCorridorSaysNothingAlongItself)
{
  const Pose2 behind{0, 0.9, 0}, ahead{0.5, 1.1, 0.2};
  const PoseBound bound = poseBound(corridor().world(), behind, exactScan(corridor(), behind, 8),
                                    ahead, exactScan(corridor(), ahead, 8), {kSigma_m});
  EXPECT_NEAR(bound.information.row(0).norm(), 0, 1e-6 * bound.information(1, 1));
  EXPECT_GT(bound.information(1, 1), 1e6);

  // Along the corridor the error is that of the prior.
  const Eigen::Vector3d prior(0.05, 0.02, 0.01);
  const Eigen::Vector3d error = mostLikelyError(bound, prior, Eigen::Matrix3d::Identity() * 1e-3);
  EXPECT_NEAR(error.x(), 0.05, 1e-6);
  EXPECT_LT(std::abs(error.y()), 1e-4);
}

TEST(PoseBound, TheErrorsSpreadAsTheInformationSays)
{
  constexpr unsigned kSeed = 7;
  constexpr int kDraws = 4000;
  test::RandomNumbers random(kSeed);
  SCOPED_TRACE(random.seedText());
  const SimulatedScan reference = exactScan(room(), kReference);
  const SimulatedScan current = exactScan(room(), kCurrent);
  const Eigen::Vector3d priorSigma(0.001, 0.002, 0.0005);
  const Eigen::Matrix3d priorCovariance = priorSigma.cwiseAbs2().asDiagonal();

  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero(), priorSpread = spread, information = spread;
  for (int draw = 0; draw < kDraws; ++draw)
  {
    const PoseBound bound =
        boundOf(room(), withNoise(reference, random), withNoise(current, random));
    const Eigen::Vector3d prior(random.normal(priorSigma.x()), random.normal(priorSigma.y()),
                                random.normal(priorSigma.z()));
    const Eigen::Vector3d alone = errorWithoutPrior(bound);
    const Eigen::Vector3d both = mostLikelyError(bound, prior, priorCovariance);
    spread += alone * alone.transpose() / kDraws;
    priorSpread += both * both.transpose() / kDraws;
    information = bound.information;
  }
  const Eigen::Matrix3d together = information + priorCovariance.inverse();
  // The covariance of the draws times the information is the identity, except for the sampling
  // error of 1 / sqrt(draws / 2) = 2 %.
  const Eigen::Matrix3d root = information.llt().matrixU(), root2 = together.llt().matrixU();
  EXPECT_TRUE((root * spread * root.transpose()).isIdentity(0.08))
      << root * spread * root.transpose();
  EXPECT_TRUE((root2 * priorSpread * root2.transpose()).isIdentity(0.08))
      << root2 * priorSpread * root2.transpose();
}

TEST(PoseBound, AnExactPriorLeavesItsOwnError)
{
  test::RandomNumbers random(3);
  const PoseBound bound = boundOf(room(), withNoise(exactScan(room(), kReference), random),
                                  withNoise(exactScan(room(), kCurrent), random));
  const Eigen::Vector3d prior(0.01, -0.02, 0.03);
  EXPECT_TRUE(mostLikelyError(bound, prior, Eigen::Matrix3d::Zero()).isApprox(prior));
}

// A robot stands still for three scans. What the noise of the middle scan adds to the first motion
// it takes off the second, so their sum has the error of one match of the first scan with the last.
TEST(PoseBound, AlongAChainTheNoiseOfTheMiddleScansCancels)
{
  test::RandomNumbers random(4);
  const auto scan = [&] { return withNoise(exactScan(room(), kReference), random); };
  const SimulatedScan first = scan(), middle = scan(), last = scan();
  const auto error = [](const SimulatedScan& from, const SimulatedScan& to)
  {
    return errorWithoutPrior(
        poseBound(room().world(), kReference, from, kReference, to, {kSigma_m}));
  };
  EXPECT_TRUE((error(first, middle) + error(middle, last)).isApprox(error(first, last), 1e-6));
  EXPECT_GT(error(first, middle).norm(), 1e-5);
}
}  // namespace psmks
