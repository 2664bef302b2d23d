/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/Guesses.h>
#include <psmks/geometry/Angle.h>

#include <cmath>

namespace psmks
{
Guesses zeroGuesses(const std::vector<ScanPair>& pairs)
{
  return {kZeroGuess, std::vector<Guess>(pairs.size())};
}

Guesses odometryGuesses(const std::vector<ScanPair>& pairs, double sigma_m, double sigma_rad)
{
  const Eigen::Array3d sigma(sigma_m, sigma_m, sigma_rad);
  const Eigen::Matrix3d covariance = sigma.square().matrix().asDiagonal();
  Guesses guesses{kOdometryGuess, {}};
  for (const ScanPair& pair : pairs)
    guesses.ofPair.push_back({pair.T_ref_cur_odometry, covariance});
  return guesses;
}

Guess displacedGuess(const Pose2& truth, double distance_m, double rotation_rad,
                     std::mt19937_64& random)
{
  const double direction_rad = std::uniform_real_distribution<double>(-kPi, kPi)(random);
  const double sign = std::bernoulli_distribution()(random) ? 1 : -1;
  return {{truth.x_m + distance_m * std::cos(direction_rad),
           truth.y_m + distance_m * std::sin(direction_rad),
           wrapAngle(truth.phi_rad + sign * rotation_rad)},
          std::nullopt};
}
}  // namespace psmks
