/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Pose2.h>

#include <optional>
#include <string>
#include <vector>

namespace psmks
{
/** The poses that a match went through, in their order. A caller who passes one to Matcher::match()
 *  gets it filled; a match without it costs nothing more. */
struct MatchTrace
{
  struct Step
  {
    /** "orientation" or "translation": half an alternation of the paper's scheme; "refinement": a
     *  start of the joint scheme after its refinement. */
    std::string stage;

    Pose2 T_ref_cur;                      //!< after the step
    std::optional<double> matchingError;  //!< there (paper, section 2.2); paper's scheme only
    std::optional<double> score;          //!< free-space score there; joint scheme only
    int kept = 0;                         //!< associated rays
    int dropped = 0;  //!< rays that a gate or an occlusion removed; paper's scheme only
  };

  /** Matching error over orientation (paper, Fig. 1c and 1d); paper's scheme only. */
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
