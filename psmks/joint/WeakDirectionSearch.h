/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Angle.h>
#include <psmks/joint/Hypotheses.h>
#include <psmks/joint/HypothesisScore.h>

#include <vector>

namespace psmks
{
/** How far along a wall, and how thoroughly, places are looked for. */
struct AlongLimits
{
  double reach_m;        //!< to either side
  double turn_rad;       //!< far along, a heading wrong by this much is tried too; 0: none
  std::size_t most;      //!< places kept
  double missedPromise;  //!< places that score less than the best one by more are dropped
};

/** The most promising places on a line through a pose, best first, but for that pose itself. */
void findPlacesAlong(const HypothesisScore& hypothesisScore, const Pose2& T_ref_cur,
                     const Eigen::Vector2d& direction, const AlongLimits& limits,
                     std::vector<Hypothesis>& places);

/** As many places as are looked at within a reach. */
std::size_t mostPlacesAlong(double reach_m);

/** The direction in which most length of wall runs; any where there is none. */
Eigen::Vector2d directionOfWalls(const std::vector<Segment>& segments);
}  // namespace psmks
