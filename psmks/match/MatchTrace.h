/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Pose2.h>

#include <string>
#include <vector>

namespace psmks
{
/** What a match did on its way: filled where the caller asks for it, for pictures, --verbose and
 *  tests. */
struct MatchTrace
{
  struct Step
  {
    std::string stage;  //!< "orientation", "translation", "hypothesis", "gauss-newton", ...
    Pose2 T_ref_cur;    //!< after the step
    double error = 0;   //!< matching error (paper) or free-space score (joint) after it
    int kept = 0;       //!< associations used
    int dropped = 0;    //!< candidates that a gate or an occlusion removed
  };

  /** Matching error over orientation (paper, Fig. 1c and 1d). */
  struct OrientationCurve
  {
    std::vector<double> phi_rad;
    std::vector<double> error;
    std::vector<int> associations;
  };

  std::vector<Step> steps;
  std::vector<OrientationCurve> orientationCurves;
};
}  // namespace psmks
