/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/StampIndex.h>
#include <psmks/eval/Trajectory.h>

#include <string>
#include <vector>

namespace psmks
{
/** A true pose of the robot at one time relative to its pose at another time. Relations of real
 * logs are verified by hand: Kuemmerle et al., On measuring the accuracy of SLAM algorithms,
 * Autonomous Robots 27 (2009). */
struct Relation
{
  double from_s = 0, to_s = 0;
  Pose2 T_from_to;
};

/** Reads a file with a relation on each line; '#' and '%' begin comments.
 *
 *     from_s to_s x y z roll pitch yaw      m, rad; projected to the plane
 *
 *  @throws TrajectoryFileError if the file cannot be read or a row is not a relation */
std::vector<Relation> readRelations(const std::string& path);

/** The error of a trajectory in one relation. */
struct RelationError
{
  double span_s = 0;     //!< time between the two poses, >= 0
  double error_m = 0;    //!< >= 0
  double error_rad = 0;  //!< >= 0
};

/** The errors of the motions of a trajectory in relations: translation and rotation of
 * T_from_to^-1 T_from_to_estimated.
 *
 * The pose at a time is the one with the nearest stamp, which is at most kStampTolerance_s away. A
 * relation is left out if one of its two poses does not exist or has no heading. The stamps of the
 * estimate may repeat and go backwards; of poses with the same stamp the first one counts. */
std::vector<RelationError> relationErrors(const Trajectory& estimate,
                                          const std::vector<Relation>& relations);
}  // namespace psmks
