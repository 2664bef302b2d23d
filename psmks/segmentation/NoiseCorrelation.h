/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/segmentation/LineFit.h>

namespace psmks
{
/** Measures how far the errors of neighbouring rays go together, from what the lines of a scan
 * leave of them.
 *
 * A scanner that gives the mean of w rays correlates the errors of neighbours by 1 - 1/w, and lines
 * have w times the variance that white noise leaves them. So it is, nearly, for walls that are
 * uneven over w rays.
 *
 * Differs from the paper: there the noise of the rays is white. */
class NoiseCorrelation
{
 public:
  /** Adds the residuals of a line. */
  void add(const LineFit& fit);

  /** SegmentedScan::raysPerReading, that is w. Of the correlation one standard deviation of its
   *  estimate is left out, which white noise reaches by chance. 1 before the first line. */
  double raysPerReading() const;

 private:
  double products_ = 0;  //!< of neighbouring residuals, in variances
  double squares_ = 0;   //!< of the residuals, in variances
  double rays_ = 0;
};
}  // namespace psmks
