/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/core/MatcherOptions.h>

#include <sstream>

namespace psmks
{
namespace
{
/** @param bound value of the option that the constraint names */
[[noreturn]] void refuse(const char* key, double value, const char* constraint, double bound)
{
  std::ostringstream text;
  text << "option '" << key << "': '" << value << "' is not accepted, allowed: " << constraint
       << ", which is " << bound;
  throw OptionError(text.str());
}
}  // namespace

void MatcherOptions::choosePaperScheme()
{
  /** Fewest rays of a segment in the paper's scheme. Unit: rays. Evidence: what is on no segment is
   * not matched in that scheme; with 6 rays one match of nine among poles and curves has fewer than
   * the 30 rays that a match needs. */
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

void MatcherOptions::validate() const
{
  // A table takes longer to make than a match: there is one for each thread, bound to a copy.
  thread_local MatcherOptions checked;
  thread_local const OptionTable table = optionTable(checked);
  checked = *this;
  table.validate();
  if (preprocessing.maxRange_m > 0 && preprocessing.maxRange_m <= preprocessing.minRange_m)
    refuse("max_range_m", preprocessing.maxRange_m, "0, or above min_range_m",
           preprocessing.minRange_m);
  if (joint.agreedScore > joint.confidentScore)
    refuse("agreed_score", joint.agreedScore, "at most confident_score", joint.confidentScore);
  if (joint.unobservableSigma_m < joint.weakDirectionSigma_m)
    refuse("unobservable_sigma_m", joint.unobservableSigma_m, "at least weak_direction_sigma_m",
           joint.weakDirectionSigma_m);
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
  listFields(table, options.wholeScan);
  return table;
}
}  // namespace psmks
