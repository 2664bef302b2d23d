/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/segmentation/RaySoA.h>

#include <vector>

namespace psmks
{
/** Range noise of a scan: the stated noise, raised to what the rays show where that is clearly more
 * (docs/derivations.md, "Range noise").
 *
 * If the stated noise does not grow with the range, and the far half of the rays is clearly noisier
 * than the near half, the result grows with the range.
 *
 * The result is never below the stated noise. Real ranges have errors that all rays of a wall share
 * and that their scatter does not show; with too small a noise such a wall would break into several
 * lines.
 *  @param rays the columns of a scan; `rays.noise` is the stated noise
 *  @param scratch storage for one number per ray */
RangeNoise shownNoise(const RaySoA& rays, std::vector<double>& scratch);
}  // namespace psmks
