/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Scan.h>
#include <psmks/segmentation/SegmentationOptions.h>
#include <psmks/segmentation/SegmentedScan.h>

#include <vector>

namespace psmks
{
/** Copies grid, ranges and stamps into `result` and settles which rays are valid: finite, above
 *  min_range_m, below the maximum range and not flagged. Invalid rays get range 0. A scan whose
 * ranges do not fit its grid has no valid ray, and nothing below 0.1 mm or beyond 1000 km is a
 * range. Segments and noise are left empty. */
void cleanScan(const Scan& scan, const PreprocessingOptions& options, SegmentedScan& result);

/** Median filter over the valid rays of a window (paper, section 1, step 1 of the original method).
 *
 * Off by default. Differs from the paper: where lines are fitted, the fit itself averages the
 * noise; a median before it moves corners and makes neighbouring errors dependent, so that the
 * covariance of a line comes out too small. */
void medianFilter(int window, std::vector<double>& scratch, SegmentedScan& scan);
}  // namespace psmks
