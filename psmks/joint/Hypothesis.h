/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Pose2.h>

namespace psmks
{
/** A pose that a search proposes as the start of a refinement. */
struct Hypothesis
{
  Pose2 T_ref_cur;
  double score = 0;  //!< by which the search orders its hypotheses, in its own unit
};
}  // namespace psmks
