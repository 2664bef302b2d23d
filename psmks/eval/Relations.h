/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/StampIndex.h>
#include <psmks/eval/Trajectory.h>

#include <string>
#include <vector>

namespace psmks
{
/** A true pose of the robot at one time, seen from where it was at another: checked by hand, as in
 *  Kuemmerle et al., On measuring the accuracy of SLAM algorithms, Autonomous Robots 27 (2009). */
struct Relation
{
  double from_s = 0, to_s = 0;
  Pose2 T_from_to;
};

/** Reads relations, one a line, '#' and '%' begin comments:
 *
 *     from_s to_s x y z roll pitch yaw      m, rad; projected to the plane
 *
 *  @throws TrajectoryFileError */
std::vector<Relation> readRelations(const std::string& path);

/** What a trajectory makes of one relation. */
struct RelationError
{
  double span_s = 0;     //!< time between its two poses, >= 0
  double error_m = 0;    //!< >= 0
  double error_rad = 0;  //!< >= 0
};

/** How far the motions of a trajectory are from those of relations, one by one: translation and
 * rotation of T_from_to^-1 T_from_to_estimated.
 *
 * A pose of the estimate counts as that of a stamp up to kStampTolerance_s away, the nearest first;
 * a relation without a pose on either side is left out. The stamps of the estimate may repeat and
 * go backwards; of poses with one stamp the first counts. */
std::vector<RelationError> relationErrors(const Trajectory& estimate,
                                          const std::vector<Relation>& relations);
}  // namespace psmks
