/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/base/OptionTable.h>
#include <psmks/match/MatchResult.h>

namespace psmks
{
/** By how much whole scans err. The bearings of all rays of a scan may be off together, and its
 * centre: a scanner whose disc does not turn evenly, or that starts its revolutions late. Nothing
 * in two scans tells such an error, for the scans fit as well; a scanner that stands still shows it
 * in the scatter of its poses. */
struct WholeScanOptions
{
  double sigma_m = 0;    //!< standard deviation of the place of a scan, in either axis
  double sigma_rad = 0;  //!< standard deviation of its heading
};

/** Adds the section `[whole_scan]` with every field of the options. */
void listFields(OptionTable& table, WholeScanOptions& options);

/** Adds the errors of both scans of a match to the covariance of its result: of usable ones, along
 * all directions, also where a direction is open. */
void addWholeScanErrors(const WholeScanOptions& options, MatchResult& result);
}  // namespace psmks
