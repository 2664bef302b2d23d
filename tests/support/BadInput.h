/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Scan.h>
#include <psmks/match/Guess.h>
#include <tests/support/RandomNumbers.h>
#include <tests/support/Scenes.h>

#include <Eigen/Core>
#include <cmath>
#include <limits>

namespace psmks::test
{
/** Random scans with all kinds of errors that no scanner should deliver. */
class BadScans
{
 public:
  explicit BadScans(RandomNumbers& random) : random_(random) {}

  Scan next()
  {
    Scan scan = random_.integer(0, 2) ? tamperedRoom() : noise();
    constexpr double sigmas_m[] = {0, 0.01, std::numeric_limits<double>::quiet_NaN(), -1, 1e-12};
    scan.rangeSigma_m = sigmas_m[random_.integer(0, 4)];
    if (random_.integer(0, 3) == 0) scan.maxRange_m = 0;
    if (random_.integer(0, 3) == 0) flagSome(scan);
    if (random_.integer(0, 19) == 0) scan.range_m.resize(scan.range_m.size() / 2);
    return scan;
  }

 private:
  /** A grid between one without rays and a full circle with many, or of very fine rays. */
  BeamGrid grid()
  {
    const int count = random_.integer(0, 3) ? random_.integer(4, 500) : random_.integer(0, 3);
    if (random_.integer(0, 1)) return BeamGrid::centered(2 * kPi, count);
    if (random_.integer(0, 9) == 0)
      return {random_.uniform(-4 * kPi, 4 * kPi), std::pow(10, random_.uniform(-5, -3)), count};
    return {random_.uniform(-kPi, kPi), random_.uniform(1e-4, 2 * kPi / (count + 1)), count};
  }

  double badRange_m()
  {
    switch (random_.integer(0, 6))
    {
      case 0:
        return std::numeric_limits<double>::quiet_NaN();
      case 1:
        return random_.integer(0, 1) ? std::numeric_limits<double>::infinity()
                                     : -std::numeric_limits<double>::infinity();
      case 2:
        return 0;
      case 3:
        return -random_.uniform(0, 10);
      case 4:
        return std::pow(10, random_.uniform(-308, 308));
      default:
        return random_.uniform(0, 30);
    }
  }

  Scan noise()
  {
    Scan scan;
    scan.grid = grid();
    scan.maxRange_m = 30;
    for (int i = 0; i < scan.grid.count(); ++i) scan.range_m.push_back(badRange_m());
    return scan;
  }

  Scan tamperedRoom()
  {
    std::mt19937 rng(static_cast<unsigned>(random_.integer(0, 1 << 30)));
    const Pose2 T_world_sensor{random_.uniform(-1, 1), random_.uniform(-1, 1),
                               random_.uniform(-kPi, kPi)};
    Scan scan = castScan(officeRoom(), T_world_sensor, grid(), 30, 0.01, rng);
    const double share = random_.uniform(0, 0.5);
    for (double& range_m : scan.range_m)
      if (random_.uniform(0, 1) < share) range_m = badRange_m();
    return scan;
  }

  void flagSome(Scan& scan)
  {
    for (std::size_t i = 0; i < scan.range_m.size(); ++i)
      scan.valid.push_back(random_.integer(0, 9) > 0);
  }

  RandomNumbers& random_;
};

/** A covariance of any size, with axes of any direction or those of the frame. */
inline Eigen::Matrix3d anyCovariance(RandomNumbers& random)
{
  Eigen::Matrix3d root = Eigen::Matrix3d::NullaryExpr([&] { return random.normal(1); });
  if (random.integer(0, 1)) root = root.diagonal().asDiagonal();
  const double widest = random.integer(0, 3) ? 4 : 150;
  for (int row = 0; row < 3; ++row) root.row(row) *= std::pow(10, random.uniform(-widest, widest));
  return (root * root.transpose()).selfadjointView<Eigen::Lower>();
}

/** A guess with all kinds of errors that no odometry should have. */
inline Guess anyGuess(RandomNumbers& random)
{
  Guess guess;
  const double reach = random.integer(0, 9) ? 1 : 1e12;
  guess.T_ref_cur = {reach * random.normal(1), reach * random.normal(1), random.uniform(-10, 10)};
  if (random.integer(0, 2) == 0)
    guess.covariance = Eigen::Vector3d(0.01, 0.02, 0.005).asDiagonal() * random.uniform(1e-6, 10);
  if (random.integer(0, 4) == 0) guess.covariance = anyCovariance(random);
  if (random.integer(0, 49) == 0) guess.T_ref_cur.x_m = std::numeric_limits<double>::quiet_NaN();
  if (random.integer(0, 49) == 0) guess.covariance = Eigen::Matrix3d::Zero().eval();
  if (random.integer(0, 49) == 0 && guess.covariance) (*guess.covariance)(0, 2) += 1;
  return guess;
}
}  // namespace psmks::test
