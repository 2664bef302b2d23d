/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/core/MatcherOptions.h>

namespace psmks
{
void MatcherOptions::choosePaperScheme()
{
  constexpr int kMinRays = 4;
  scheme = Scheme::Paper;
  segmentation.filter = LineFilter::Ekf;
  segmentation.minRays = kMinRays;
}

MatcherOptions MatcherOptions::paperScheme()
{
  MatcherOptions options;
  options.choosePaperScheme();
  return options;
}

OptionTable optionTable(MatcherOptions& options)
{
  OptionTable table;
  table.beginSection("matcher", "The matching scheme.");
  table.add(
      "scheme", options.scheme, {"joint", "paper"},
      "joint: Gauss-Newton over position and heading together; paper: alternating orientation "
      "search and translation regression");
  listFields(table, options.preprocessing);
  listFields(table, options.segmentation);
  listFields(table, options.paper);
  listFields(table, options.joint);
  return table;
}
}  // namespace psmks
