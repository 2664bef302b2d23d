/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/segmentation/RaySoA.h>

namespace psmks
{
/** A line fitted to rays, and the figures that tell whether the rays lie on one straight line. */
struct LineFit
{
  /** The fitted line with its covariance for the stated noise of the rays. */
  Line line;

  /** Unit normal of the line. */
  Eigen::Vector2d normal = Eigen::Vector2d::UnitX();

  /** Number of rays that were fitted. */
  int rays = 0;

  /** Sum of the squared residuals over their variances, with `rays - 2` degrees of freedom. */
  double chi2 = 0;

  /** Coefficient of the squared distance along the line when a quadratic term is fitted with the
   * line; positive where the wall bulges away from the scanner. */
  double curvature_1_m = 0;

  /** Standard deviation of the curvature. */
  double curvatureSigma_1_m = 0;

  /** Correlation of neighbouring residuals in units of its own standard deviation. It is about
   * standard normal on a straight line, and large where two lines were taken for one. */
  double whiteness = 0;
};

/** The rays of a line: the `rays` positions from `first` to `last` (both included) that carry the
 * mark `mark`. */
struct RayRange
{
  int first, last;
  int mark;
  int rays;
};

/** The line n.p = r0 at which a fit is linearised. */
struct LineStart
{
  Eigen::Vector2d normal;
  double r0_m;
};

/** Fits (r0, phi0) to the rays of a range by least squares, and tests the fit for curvature and for
 * whiteness.
 *
 * One Gauss-Newton step is made. It is enough when the start comes from the linear filter, whose
 * line is off by less than its own standard deviation; the step removes the bias that comes from
 * weighting each ray by its measured range (docs/derivations.md, "Lines").
 *  @return a fit whose `chi2` is 0 and whose line is the default one where the rays do not fix a
 * line */
LineFit fitLine(const RaySoA& rays, const RayRange& range, const LineStart& start);
}  // namespace psmks
