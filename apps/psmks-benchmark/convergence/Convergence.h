/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/core/MatcherOptions.h>
#include <psmks/eval/PairsFile.h>
#include <psmks/geometry/Angle.h>

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

namespace psmks
{
/** How far from the truth the guesses are: every distance with every rotation. */
struct ConvergenceGrid
{
  std::vector<double> distances_m;
  std::vector<double> rotations_rad;

  /** So many steps each, evenly from 0 to the largest. */
  static ConvergenceGrid even(double maxDistance_m, double maxRotation_rad, int steps);

  // Where nothing else is said.
  static constexpr double kMaxDistance_m = 1.5;
  static constexpr double kMaxRotation_deg = 60;
  static constexpr int kSteps = 7;
};

struct ConvergenceOptions
{
  ConvergenceGrid grid =
      ConvergenceGrid::even(ConvergenceGrid::kMaxDistance_m,
                            degToRad(ConvergenceGrid::kMaxRotation_deg), ConvergenceGrid::kSteps);
  std::vector<std::string> matchers;
  MatcherOptions matcherOptions;
  unsigned seed = 1;  //!< of the directions
};

/** The area of convergence of a matcher: the share of successes (see isSuccess()) in each cell. */
struct ConvergenceMap
{
  std::string matcher;
  Eigen::MatrixXd successShare;  //!< rotations x distances
};

/** Every matcher on every pair from guesses in every cell of the grid: the truth, moved by the
 * distance in a random direction and turned by the rotation, this or that way round at random. A
 * guess is a starting point without covariance, and the same for every matcher.
 *
 * @param pairs at least one
 * @param progress called with the share that is done, 0 to 1
 * @return one map a matcher
 * @throws OptionError for a matcher that does not exist or options that it does not accept */
std::vector<ConvergenceMap> measureConvergence(const std::vector<ScanPair>& pairs,
                                               const ConvergenceOptions& options,
                                               const std::function<void(double)>& progress);
}  // namespace psmks
