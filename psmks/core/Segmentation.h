/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/core/Scan.h>
#include <psmks/core/SegmentationOptions.h>
#include <psmks/core/SegmentedScan.h>

namespace psmks
{
/** Preprocessing and Kalman Segmentation of a scan (paper, section 2, step 1).
 *
 * Never throws for bad data: a scan without a valid ray gives no segments. Allocates nothing once
 * `result` has held a scan of as many rays.
 *
 * @param[out] result the cleaned scan with its segments; whatever it held is replaced */
void segmentScan(const Scan& scan, const PreprocessingOptions& preprocessing,
                 const SegmentationOptions& options, SegmentedScan& result);
}  // namespace psmks
