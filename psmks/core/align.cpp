/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/core/Matcher.h>
#include <psmks/core/align.h>

namespace psmks
{
namespace
{
template <class Real>
Scan toScan(const std::vector<Real>& range_m, const BeamGrid& grid)
{
  Scan scan;
  scan.grid = grid;
  scan.range_m.assign(range_m.begin(), range_m.end());
  return scan;
}
}  // namespace

MatchResult align(const Scan& reference, const Scan& current, const Guess& guess,
                  const MatcherOptions& options)
{
  MatcherWorkspace workspace;
  return Matcher(options).match(reference, current, guess, workspace);
}

MatchResult align(const std::vector<double>& reference_m, const std::vector<double>& current_m,
                  const BeamGrid& grid, const Guess& guess, const MatcherOptions& options)
{
  return align(toScan(reference_m, grid), toScan(current_m, grid), guess, options);
}

MatchResult align(const std::vector<float>& reference_m, const std::vector<float>& current_m,
                  const BeamGrid& grid, const Guess& guess, const MatcherOptions& options)
{
  return align(toScan(reference_m, grid), toScan(current_m, grid), guess, options);
}
}  // namespace psmks
