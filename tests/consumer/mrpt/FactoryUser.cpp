/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <mrpt/rtti/CObject.h>

#include <iostream>

/** Finds the matcher by its name alone, as programs do that read the name of an algorithm from a
 *  file. */
int main()
{
  const auto matcher = mrpt::rtti::classFactory("psmks::ScanMatcher");
  std::cout << (matcher ? "psmks::ScanMatcher is known" : "psmks::ScanMatcher is unknown") << '\n';
  return matcher ? 0 : 1;
}
