/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <mrpt/obs/stock_observations.h>
#include <psmks/mrpt/ScanMatcher.h>

#include <iostream>

int main()
{
  mrpt::obs::CObservation2DRangeScan scan;
  mrpt::obs::stock_observations::example2DRangeScan(scan);
  psmks::ScanMatcher matcher;
  psmks::ScanMatcher::ReturnInfo info;
  matcher.align(scan, scan, mrpt::poses::CPosePDFGaussian(), &info);
  std::cout << info.match.report() << '\n';
  return info.match.usable() ? 0 : 1;
}
