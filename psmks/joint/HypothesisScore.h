/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Pose2.h>
#include <psmks/joint/JointOptions.h>
#include <psmks/joint/ScanScores.h>

namespace psmks
{
/** How much a start promises before it is refined: its rough score, less where it is remote. Of
 * starts that explain the scans alike - a square room looks the same four ways - the one nearer the
 * guess goes first. */
class HypothesisScore
{
 public:
  /** @param scores, options are kept by reference */
  HypothesisScore(const ScanScores& scores, const Pose2& guess_T_ref_cur,
                  const JointOptions& options);

  double of(const Pose2& T_ref_cur) const;

 private:
  const ScanScores& scores_;
  const JointOptions& options_;
  Pose2 T_guess_ref_;
};
}  // namespace psmks
