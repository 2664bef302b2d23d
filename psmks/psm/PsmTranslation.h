/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/psm/PsmProjection.h>

namespace psmks
{
/** What a translation step is made from, and the step. */
struct PsmTranslation
{
  int pairs = 0;          //!< rays that took part
  bool solvable = false;  //!< false where the pairs do not fix two coordinates
  Eigen::Vector2d step_m = Eigen::Vector2d::Zero();  //!< to add to the position, reference frame
};

/** The shift of the current scan that evens out the differences d of paired ranges best, by one
 *  step of weighted least squares (Diosi and Kleeman 2007): d = cos b dx + sin b dy at
 *  bearing b, weighted by C / (d^2 + C).
 *
 *  A pair is Good on both sides, its projected range between minProjectedRange_m and the maximum
 *  range, and its ranges differ by less than maxPairDifference_m.
 *
 *  @param weightScale_m the root of C */
PsmTranslation solvePsmTranslation(const PsmScan& reference, const PsmProjection& projection,
                                   double weightScale_m, const PsmOptions& options);
}  // namespace psmks
