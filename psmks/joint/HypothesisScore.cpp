/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/joint/HypothesisScore.h>

#include <cmath>

namespace psmks
{
HypothesisScore::HypothesisScore(const ScanScores& scores, const Pose2& guess_T_ref_cur,
                                 const JointOptions& options)
    : scores_(scores), options_(options), T_guess_ref_(guess_T_ref_cur.inverse())
{
}

double HypothesisScore::of(const Pose2& T_ref_cur) const
{
  /** What the score of a hypothesis counts less at the limits of the search. Unit: score. Evidence:
   * none of its own; it was chosen with the scheme as a whole. */
  constexpr double kAtLimits = 0.05;
  const Pose2 T_guess_start = T_guess_ref_ * T_ref_cur;
  const double normalizedDistance = (std::abs(T_guess_start.phi_rad) / options_.searchAngle_rad +
                                     T_guess_start.translation().norm() / options_.searchRadius_m) /
                                    2;
  return scores_.roughScore(T_ref_cur) - kAtLimits * normalizedDistance;
}
}  // namespace psmks
