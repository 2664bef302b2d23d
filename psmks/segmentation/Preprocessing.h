/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Scan.h>
#include <psmks/segmentation/SegmentationOptions.h>
#include <psmks/segmentation/SegmentedScan.h>

#include <vector>

namespace psmks
{
/** Copies grid, ranges and stamps of a scan and decides which rays are valid.
 *
 * A ray is valid if its range is finite, above `minRange_m`, below both the scan's and the option's
 * maximum range, between 0.1 mm and 1000 km, and not flagged invalid. A scan whose number of ranges
 * is not that of its grid has no valid ray.
 *
 * Where only every k-th ray returns, eight or more of them, the others are taken out: the grid of
 * the result then has k times the increment, and its rays are numbered anew.
 *  @param[out] result invalid rays get range 0; segments and noise are left empty */
void cleanScan(const Scan& scan, const PreprocessingOptions& options, SegmentedScan& result);

/** Whether a scan has a ray that is valid by the default options. */
bool hasReturns(const Scan& scan);

/** Replaces each valid range by the median of the valid ranges in a window of rays around it
 * (paper, section 1, step 1 of the original method).
 *
 * Differs from the paper: the filter is off by default. Where lines are fitted, the fit itself
 * averages the noise. A median before the fit moves corners and makes neighbouring errors
 * dependent, so that the covariance of a line comes out too small.
 *  @param window number of rays; 0 or 1 leaves the scan as it is
 *  @param scratch storage for the ranges and one window
 *  @param[in,out] scan a cleaned scan */
void medianFilter(int window, std::vector<double>& scratch, SegmentedScan& scan);
}  // namespace psmks
