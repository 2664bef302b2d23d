/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Pose2.h>
#include <psmks/joint/JointOptions.h>
#include <psmks/joint/ScanScores.h>

namespace psmks
{
/** Ranks starts before they are refined: the rough free-space score, lowered by up to 0.05 at the
 * limits of the search about the guess. Of starts that explain the scans alike - a square room
 * looks the same four ways - the one nearer to the guess is refined first. */
class HypothesisScore
{
 public:
  /** @param scores, options are kept by reference */
  HypothesisScore(const ScanScores& scores, const Pose2& guess_T_ref_cur,
                  const JointOptions& options);

  /** Score of a start, about 0 to 1; the higher the more promising. */
  double of(const Pose2& T_ref_cur) const;

 private:
  const ScanScores& scores_;
  const JointOptions& options_;
  Pose2 T_guess_ref_;
};
}  // namespace psmks
