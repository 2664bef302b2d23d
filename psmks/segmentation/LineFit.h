/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/segmentation/RaySoA.h>

namespace psmks
{
/** A line fitted to rays, with what tells whether they lie on one. */
struct LineFit
{
  Line line;                                          //!< covariance for the noise of the rays
  Eigen::Vector2d normal = Eigen::Vector2d::UnitX();  //!< of the line
  int rays = 0;
  double chi2 = 0;  //!< sum of squared residuals / variance; rays - 2 degrees of freedom
  double curvature_1_m =
      0;  //!< coefficient of the squared distance along the line, bulging outwards
  double curvatureSigma_1_m = 0;
  double whiteness =
      0;  //!< correlation of neighbouring residuals, in its standard deviations: about
          //!< N(0, 1) on a straight line, large where two lines were taken for one
};

/** Positions `first` to `last`; those whose mark equals `mark`, `rays` of them, belong to the line.
 */
struct RayRange
{
  int first, last;
  int mark;
  int rays;
};

/** Where a fit begins: the line n.p = r0. */
struct LineStart
{
  Eigen::Vector2d normal;
  double r0_m;
};

/** Least squares of (r0, phi0) over the rays of a range: one Gauss-Newton step from `start`, which
 * the linear filter's line is close enough for (it is off by less than its own sigma), and the
 * tests for curvature (a quadratic term along the line, fitted with it) and whiteness. */
LineFit fitLine(const RaySoA& rays, const RayRange& range, const LineStart& start);
}  // namespace psmks
