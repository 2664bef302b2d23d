/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/joint/Hypotheses.h>
#include <psmks/joint/ScanScores.h>

#include <vector>

namespace psmks
{
/** How far about a guess, and how many places of the grid are followed. */
struct CorrelativeLimits
{
  double radius_m, angle_rad;
  std::size_t followed;
};

/** Poses far about a guess that nobody measured, or about a measured one of which lines know
 * nothing, found by trying a grid of them: where lines are few or short they vote for nothing, and
 * a scanner that moved by metres between two scans shares few of them. Coarse to fine: the best
 * poses of the grid are moved by ever smaller steps to where more rays lie on surfaces. */
class CorrelativeSearch
{
 public:
  /** Replaces the hypotheses by these starts, those that explain most first; of those that lead to
   * one place only the best. */
  void propose(const ScanScores& scores, const Pose2& guess_T_ref_cur,
               const CorrelativeLimits& limits, std::vector<Hypothesis>& hypotheses);

  /** Takes the memory of a search, so that none of this size takes more. */
  void reserve(double radius_m, double angle_rad);

 private:
  void scoreGrid(const ScanScores& scores, const Pose2& guess_T_ref_cur,
                 const CorrelativeLimits& limits);
  void climb(const ScanScores& scores);

  std::vector<Hypothesis> places_;
};
}  // namespace psmks
