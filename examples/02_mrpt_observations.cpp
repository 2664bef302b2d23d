/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */

/** \file
 * Example 2: the motion of a robot between two of MRPT's scan observations.
 *
 * Takes two scans that come with MRPT and a rough guess of the motion between them, and prints the
 * result of the match, then the pose as MRPT's Gaussian with its covariance. */

#include <mrpt/obs/stock_observations.h>
#include <psmks/mrpt/ScanMatcher.h>

#include <iostream>

int main()
{
  mrpt::obs::CObservation2DRangeScan reference, current;
  mrpt::obs::stock_observations::example2DRangeScan(reference, 0);
  mrpt::obs::stock_observations::example2DRangeScan(current, 1);
  const mrpt::poses::CPosePDFGaussian guess(mrpt::poses::CPose2D(0.8, 0, 0));  // m, m, rad

  psmks::ScanMatcher matcher;
  psmks::ScanMatcher::ReturnInfo info;
  const auto pose = matcher.align(reference, current, guess, &info);
  std::cout << info.match.report() << '\n' << *pose << '\n';
  return info.match.usable() ? 0 : 1;
}
