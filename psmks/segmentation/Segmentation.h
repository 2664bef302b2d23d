/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Scan.h>
#include <psmks/segmentation/LineGrowing.h>
#include <psmks/segmentation/ScannerNoise.h>
#include <psmks/segmentation/SegmentationOptions.h>
#include <psmks/segmentation/SegmentedScan.h>

namespace psmks
{
/** Scratch of the segmentation, kept between scans so that nothing is allocated after the first. */
struct SegmentationBuffers
{
  std::vector<double> scratch;  //!< one number per ray, for medians
  RaySoA rays;
  std::vector<LineRun> runs;
};

/** Preprocessing and Kalman Segmentation of a scan (paper, section 2, step 1).
 *
 * Steps: invalid rays out; range sigma settled; lines grown from seeds of consecutive rays by a
 * Kalman filter with an innovation gate, to the right and then to the left; contested corner rays
 * given to the line that explains them; collinear neighbours merged; every line finished by
 * Gauss-Newton; what is short, curved or noisy is dropped and its rays stay single points.
 *
 * Never throws for bad data: a scan without a valid ray gives no segments. Allocates nothing once
 * `buffers` and `result` have served a scan of as many rays.
 *
 * @param[out] result the cleaned scan with its segments; whatever it held is replaced
 * @param scanner what other scans of the scanner have shown; by default a scan is believed */
void segmentScan(const Scan& scan, const PreprocessingOptions& preprocessing,
                 const SegmentationOptions& options, SegmentationBuffers& buffers,
                 SegmentedScan& result, const ScannerNoise& scanner = {});
}  // namespace psmks
