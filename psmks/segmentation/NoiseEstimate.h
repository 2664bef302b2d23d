/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/segmentation/RaySoA.h>

#include <vector>

namespace psmks
{
/** The noise that rays are said to have, raised to what they show where that is clearly more.
 *
 * Where nothing is said of growth and the far half of the rays is clearly noisier than the near
 * one, the noise that is found grows with the range.
 *
 * Never lowered: real ranges are wrong by more than their scatter, alike for all rays of a wall,
 * and lines that are held to be better than they are break at that.
 *  @param rays with the noise that they are said to have */
RangeNoise shownNoise(const RaySoA& rays, std::vector<double>& scratch);
}  // namespace psmks
