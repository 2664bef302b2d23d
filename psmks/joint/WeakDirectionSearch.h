/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Angle.h>
#include <psmks/joint/Hypotheses.h>
#include <psmks/joint/HypothesisScore.h>

#include <vector>

namespace psmks
{
/** How far along a direction places are scored, and which of them are kept. */
struct AlongLimits
{
  double reach_m;    //!< to either side
  double turn_rad;   //!< farther than 0.8 m away, headings turned by this much to either side are
                     //!< scored too; 0: none
  std::size_t most;  //!< places that are kept at most
  double missedPromise;  //!< places that score less than the best one by more are dropped
};

/** Finds the places on a line through a pose, 0.1 m apart, where the score of starts has its
 * highest maxima, but for that pose itself and its two neighbours. Replaces `places`, best first.
 */
void findPlacesAlong(const HypothesisScore& hypothesisScore, const Pose2& T_ref_cur,
                     const Eigen::Vector2d& direction, const AlongLimits& limits,
                     std::vector<Hypothesis>& places);

/** Number of places that are scored within a reach, for reserving memory. */
std::size_t mostPlacesAlong(double reach_m);

/** Unit vector along which most length of wall runs, each wall weighed by its length; any unit
 * vector where there is no segment. */
Eigen::Vector2d directionOfWalls(const std::vector<Segment>& segments);
}  // namespace psmks
