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
/** The distances and rotations of the guesses from the truth. All combinations are used. */
struct ConvergenceGrid
{
  std::vector<double> distances_m;
  std::vector<double> rotations_rad;

  /** A grid with a number of steps on each axis, evenly spaced from 0 to the largest value. */
  static ConvergenceGrid even(double maxDistance_m, double maxRotation_rad, int steps);

  // Defaults of the command line.
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
  unsigned seed = 1;  //!< seed of the random directions
};

/** The area of convergence of a matcher: the share of successes (isSuccess()) for each cell of the
 * grid. */
struct ConvergenceMap
{
  std::string matcher;
  Eigen::MatrixXd successShare;  //!< rotations x distances
};

/** Runs all matchers on all pairs from guesses in all cells of the grid. A guess is the truth,
 * moved by the distance in a random direction and turned by the rotation to a random side. It has
 * no covariance and is the same for all matchers.
 *
 * @param pairs at least one
 * @param progress called with the share of the work that is done, 0 to 1
 * @return a map for each matcher; none where a signal asks the program to stop
 * @throws OptionError for a matcher that does not exist or options that it does not accept */
std::vector<ConvergenceMap> measureConvergence(const std::vector<ScanPair>& pairs,
                                               const ConvergenceOptions& options,
                                               const std::function<void(double)>& progress);
}  // namespace psmks
