/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/core/MatcherOptions.h>
#include <psmks/eval/Table.h>

#include <functional>
#include <string>
#include <vector>

namespace psmks
{
struct GrowthOptions
{
  std::vector<std::string> matchers{"psmks"};
  std::vector<int> rays{181, 361, 541, 721, 1081, 1441, 2001};
  int pairs = 100;
  int repeats = 3;
  unsigned seed = 1;
  MatcherOptions matcherOptions;
};

/** How the time of a matcher grows with the rays of the scans. */
struct GrowthRun
{
  std::string matcher;
  std::vector<int> rays;
  std::vector<double> median_s;  //!< of a match, for each number of rays

  /** Slope of log time over log rays by least squares: 1 = linear. NaN for less than two numbers of
   * rays. */
  double exponent() const;
};

/** Every matcher on the same pairs of places, from a zero guess, seen with ever more rays over 180
 * degrees: medium displacements in generated office floors, range noise 1 cm.
 *
 * Interleaved: for each repeat, for each number of rays, for each pair, each matcher in turn. The
 * time of a pair is the smallest of its repeats, from the raw scans to the result.
 *
 *  @param progress called with the share that is done, 0 to 1
 *  @throws OptionError for a matcher that does not exist or options that it does not accept */
std::vector<GrowthRun> runGrowth(const GrowthOptions& options,
                                 const std::function<void(double)>& progress);

/** A row for each matcher: its exponent, and its median time for each number of rays. */
Table growthTable(const std::vector<GrowthRun>& runs);
}  // namespace psmks
