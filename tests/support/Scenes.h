/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Pose2.h>
#include <psmks/geometry/Scan.h>
#include <psmks/segmentation/SegmentedScan.h>

#include <Eigen/Core>
#include <random>
#include <vector>

namespace psmks
{
/** A straight, opaque wall from a to b, world frame, metres. */
struct Wall
{
  Eigen::Vector2d a, b;
};

/** Index of the wall that each ray meets first within maxRange_m, -1 where it meets none. */
std::vector<int> wallsSeen(const std::vector<Wall>& walls, const Pose2& T_world_sensor,
                           const BeamGrid& grid, double maxRange_m);

/** The exact scan of the walls from a pose, plus Gaussian noise of `sigma_m` on every return. A ray
 *  that meets nothing reads maxRange_m, which is no return. */
Scan castScan(const std::vector<Wall>& walls, const Pose2& T_world_sensor, const BeamGrid& grid,
              double maxRange_m, double sigma_m, std::mt19937& rng);

/** The exact scan. */
Scan castScan(const std::vector<Wall>& walls, const Pose2& T_world_sensor, const BeamGrid& grid,
              double maxRange_m = 30);

/** The best segmentation there can be of a scan cast from `T_world_sensor`: every ray is known to
 * its true wall; each run of at least 6 consecutive rays on a wall is a segment with its maximum
 *  likelihood line and the Cramer-Rao bound as its covariance (for a sigma of 1 cm where the scan
 * is exact). Segment::sigma_m is that sigma. */
SegmentedScan segmentByWalls(const Scan& scan, const std::vector<Wall>& walls,
                             const Pose2& T_world_sensor);

/** A closed outline: a wall between every two successive corners and from the last to the first. */
std::vector<Wall> outline(const std::vector<Eigen::Vector2d>& corners_m);

/** A rectangle about `centre_m`, turned by `phi_rad`: 4 walls. */
std::vector<Wall> box(const Eigen::Vector2d& centre_m, double length_m, double width_m,
                      double phi_rad = 0);

/** 6 x 6 m about the origin. */
std::vector<Wall> squareRoom();

/** 8 x 6 m with a step in a wall, a pillar and a slanted cupboard: no symmetry, many corners. */
std::vector<Wall> officeRoom();

/** Two bare walls along x, 2 m apart and 60 m long: nothing fixes the position along x. */
std::vector<Wall> corridor();

/** 10 x 8 m with 8 boxes of random size, place and angle; 1.2 m about the origin is free. */
std::vector<Wall> clutteredRoom(unsigned seed);
}  // namespace psmks
