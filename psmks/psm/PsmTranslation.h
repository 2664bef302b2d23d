/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/psm/PsmProjection.h>

namespace psmks
{
/** A translation step and the number of pairs that it was computed from. */
struct PsmTranslation
{
  int pairs = 0;          //!< number of paired rays
  bool solvable = false;  //!< whether the pairs determine both coordinates
  Eigen::Vector2d step_m = Eigen::Vector2d::Zero();  //!< to add to the position, reference frame
};

/** The shift of the current scan that minimises the differences d of paired ranges, by one step of
 * weighted least squares (Diosi and Kleeman 2007): d = cos b dx + sin b dy at bearing b, with the
 * weight C / (d^2 + C).
 *
 * Two ranges are a pair if both are Good, the projected one is between minProjectedRange_m and the
 * maximum range, and they differ by less than maxPairDifference_m.
 *
 *  @param weightScale_m the square root of C */
PsmTranslation solvePsmTranslation(const PsmScan& reference, const PsmProjection& projection,
                                   double weightScale_m, const PsmOptions& options);
}  // namespace psmks
