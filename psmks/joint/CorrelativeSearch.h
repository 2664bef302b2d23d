/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/joint/Hypotheses.h>
#include <psmks/joint/ScanScores.h>

#include <vector>

namespace psmks
{
/** The window of a grid search about a guess, and how many of its poses are followed. */
struct CorrelativeLimits
{
  double radius_m, angle_rad;  //!< greatest displacement, and rotation to either side
  std::size_t followed;        //!< best poses of the grid that are moved uphill
};

/** Proposes starts by scoring a grid of poses about a guess (correlative scan matching, coarse to
 * fine). It finds what HypothesisSearch cannot: poses of scans whose lines are few or short, and
 * far poses that share few lines with the reference. The grid has steps of 0.5 m and 6 degrees; its
 * best poses are moved by ever smaller steps to where more rays lie on surfaces. */
class CorrelativeSearch
{
 public:
  /** Replaces the hypotheses by at most twelve starts, those that explain most rays first. Of
   * starts nearer to each other than 0.3 m and 5 degrees only the best is kept. */
  void propose(const ScanScores& scores, const Pose2& guess_T_ref_cur,
               const CorrelativeLimits& limits, std::vector<Hypothesis>& hypotheses);

  /** Reserves the memory of a search of this size, so that none of at most this size allocates. */
  void reserve(double radius_m, double angle_rad);

 private:
  void scoreGrid(const ScanScores& scores, const Pose2& guess_T_ref_cur,
                 const CorrelativeLimits& limits);
  void climb(const ScanScores& scores);

  std::vector<Hypothesis> places_;
};
}  // namespace psmks
