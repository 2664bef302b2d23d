/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/psm/PsmProjection.h>

#include <optional>

namespace psmks
{
/** Turns the current scan on the spot until it covers the reference best (Diosi and Kleeman 2007):
 *  to turn is to shift the projected ranges by whole rays, so one projection serves
 *  all turns within the search window. The error of a turn is the mean absolute difference of the
 *  ranges that are Good on both sides; a parabola through the smallest and its neighbours goes
 *  below the spacing of the rays.
 *
 *  On a closed grid the shifted ranges go round; on an open one those that leave the view are left
 *  out.
 *
 *  @param errors_m buffer; afterwards the error of every shift, infinite where nothing pairs
 *  @return the turn to add to the heading, rad; nothing where no shift has a pair */
std::optional<double> findPsmTurn_rad(const PsmScan& reference, const PsmProjection& projection,
                                      double searchWindow_rad, std::vector<double>& errors_m);

/** Where the parabola through (-1, left), (0, middle), (1, right) has its minimum; 0, the middle,
 *  unless both neighbours are higher and the curve is not nearly flat. */
double parabolaMinimum(double left, double middle, double right);
}  // namespace psmks
