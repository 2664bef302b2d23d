/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/features/ScanFeatures.h>
#include <psmks/joint/Hypothesis.h>

#include <vector>

namespace psmks
{
/** How far about a guess line pairs may vote, and how many headings are followed. */
struct VoteLimits
{
  double radius_m;   //!< greatest displacement along either axis of the reference
  double angle_rad;  //!< greatest rotation to either side
  int votedAngles;   //!< headings with most votes whose translations are voted for
};

/** A rotation that many pairs of segments agree on. */
struct VotedAngle
{
  double phi_rad;  //!< heading of the current frame in the reference frame
  double votes;    //!< lengths of the pairs of segments that agree on it, m
};

/** Votes of segment angles and of line intersections.
 *
 * Every pair of a current and a reference segment proposes the rotation that makes them parallel;
 * the angles of true pairs agree, whatever the translation. At a voted angle every parallel pair
 * fixes the translation across its line, n.t = d_ref - d_cur, and two pairs that are not parallel
 * fix all of it: the true translation collects many of these intersections (docs/derivations.md).
 */
class LineVotes
{
 public:
  /** Appends the hypotheses within the limits about the guess, heading by heading, those with most
   * votes first. */
  void propose(const ScanFeatures& reference, const ScanFeatures& current,
               const Pose2& guess_T_ref_cur, const VoteLimits& limits,
               std::vector<Hypothesis>& hypotheses);

 private:
  struct Constraint
  {
    double nx, ny, offset_m;  //!< n.t = offset, t from the guess
    double weight_m;
  };
  struct Cell
  {
    double votes, sumX_m, sumY_m;
  };

  void voteAngles(const ScanFeatures& reference, const ScanFeatures& current, double guess_rad,
                  const VoteLimits& limits);
  void voteTranslations(const ScanFeatures& reference, const ScanFeatures& current,
                        const Pose2& guess, const VotedAngle& angle, const VoteLimits& limits);
  void collectPeaks(const Pose2& guess, const VotedAngle& angle,
                    std::vector<Hypothesis>& hypotheses) const;
  void cast(double x_m, double y_m, double votes, double radius_m);

  std::vector<double> histogram_;
  std::vector<VotedAngle> angles_;
  std::vector<Constraint> constraints_;
  std::vector<Cell> grid_;
  int gridSide_ = 0;
};
}  // namespace psmks
