/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Scan.h>
#include <psmks/segmentation/LineGrowing.h>
#include <psmks/segmentation/ScannerNoise.h>
#include <psmks/segmentation/SegmentationOptions.h>
#include <psmks/segmentation/SegmentedScan.h>

namespace psmks
{
/** Storage of the segmentation. Kept from scan to scan, it saves every allocation after the first.
 */
struct SegmentationBuffers
{
  std::vector<double> scratch;  //!< one number per ray, for medians
  std::vector<int> spacings;    //!< distances between returns, in rays
  RaySoA rays;
  std::vector<LineRun> runs;
};

/** Preprocessing and Kalman Segmentation of a scan (paper, section 2, step 1;
 * docs/how-it-works.md, "Find the lines").
 *
 * 1. cleanScan() and medianFilter() take out invalid rays.
 * 2. findRounding() and shownNoise() determine the noise of the ranges.
 * 3. LineGrowing grows lines from seeds of consecutive rays by a Kalman filter with an innovation
 *    gate, moves their corners to the most likely place, and merges collinear neighbours.
 * 4. fitLine() fits every line to its rays by one Gauss-Newton step. Lines that are two are cut.
 *    Lines that are short, curved or noisy are dropped, and their rays stay single points.
 *
 * Bad data never throw: a scan without a valid ray has no segments. Nothing is allocated once
 * `buffers` and `result` have served a scan of as many rays, but the grid of a scan of which only
 * every k-th ray returns.
 *
 * @param[out] result the cleaned scan with its segments; what it held is replaced
 * @param scanner what earlier scans of the same scanner have shown; by default every scan's own
 * noise is believed */
void segmentScan(const Scan& scan, const PreprocessingOptions& preprocessing,
                 const SegmentationOptions& options, SegmentationBuffers& buffers,
                 SegmentedScan& result, const ScannerNoise& scanner = {});
}  // namespace psmks
