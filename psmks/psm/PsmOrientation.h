/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/psm/PsmProjection.h>

#include <optional>

namespace psmks
{
/** Finds the turn of the current scan on the spot that fits the reference best (Diosi and Kleeman
 * 2007). To turn the scan is to shift the projected ranges by whole rays, so one projection is
 * enough for all turns in the search window. The error of a turn is the mean absolute difference of
 * the ranges that are Good in both scans. A parabola through the smallest error and its neighbours
 * refines the turn below the spacing of the rays.
 *
 * On a closed grid the shifted ranges wrap; on an open one those that leave the field of view are
 * left out.
 *
 *  @param errors_m buffer; afterwards the error of each shift, infinite for a shift without pairs
 *  @return the turn to add to the heading, rad; nothing if no shift has a pair */
std::optional<double> findPsmTurn_rad(const PsmScan& reference, const PsmProjection& projection,
                                      double searchWindow_rad, std::vector<double>& errors_m);

/** The abscissa of the minimum of the parabola through (-1, left), (0, middle), (1, right). It is 0
 * if a neighbour is lower than the middle or the curve is nearly flat. */
double parabolaMinimum(double left, double middle, double right);
}  // namespace psmks
