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

/** The growth of the time of a matcher with the number of rays. */
struct GrowthRun
{
  std::string matcher;
  std::vector<int> rays;
  std::vector<double> median_s;  //!< median time of a match for each number of rays

  /** The slope of log time over log rays by least squares: 1 if the growth is linear. NaN for fewer
   * than two numbers of rays. */
  double exponent() const;
};

/** Runs all matchers from a zero guess on the same pairs of places with increasing numbers of rays
 * over 180 degrees. Displacements are medium, worlds are generated office floors, and the range
 * noise is 1 cm.
 *
 * The order is interleaved: for each repeat, for each number of rays, for each pair, all matchers
 * run in turn. The time of a match is measured from the raw scans to the result, and the smallest
 * one of the repeats counts.
 *
 *  @param progress called with the share of the work that is done, 0 to 1
 *  @throws OptionError for a matcher that does not exist or options that it does not accept */
std::vector<GrowthRun> runGrowth(const GrowthOptions& options,
                                 const std::function<void(double)>& progress);

/** A table with a row for each matcher: its exponent and its median time for each number of rays.
 */
Table growthTable(const std::vector<GrowthRun>& runs);
}  // namespace psmks
