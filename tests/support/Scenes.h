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
/** A straight, opaque wall from a to b, in metres in the frame of the world. */
struct Wall
{
  Eigen::Vector2d a, b;
};

/** The index of the wall that each ray meets first within maxRange_m, or -1 if it meets none. */
std::vector<int> wallsSeen(const std::vector<Wall>& walls, const Pose2& T_world_sensor,
                           const BeamGrid& grid, double maxRange_m);

/** Casts a scan of the walls with Gaussian noise of `sigma_m` on each return. A ray that meets
 * nothing has the range maxRange_m, which is no return. */
Scan castScan(const std::vector<Wall>& walls, const Pose2& T_world_sensor, const BeamGrid& grid,
              double maxRange_m, double sigma_m, std::mt19937& rng);

/** Casts a scan without noise. */
Scan castScan(const std::vector<Wall>& walls, const Pose2& T_world_sensor, const BeamGrid& grid,
              double maxRange_m = 30);

/** The ideal segmentation of a scan that was cast from `T_world_sensor`, from the known walls of
 * its rays. Each run of at least 6 consecutive rays on a wall is a segment, with its maximum
 * likelihood line and the Cramer-Rao bound as its covariance. The sigma of the ranges, which is
 * also Segment::sigma_m, is taken for 1 cm if the scan has no noise. */
SegmentedScan segmentByWalls(const Scan& scan, const std::vector<Wall>& walls,
                             const Pose2& T_world_sensor);

/** A closed outline, with a wall between each two successive corners and from the last to the
 * first.
 */
std::vector<Wall> outline(const std::vector<Eigen::Vector2d>& corners_m);

/** The four walls of a rectangle about `centre_m`, turned by `phi_rad`. */
std::vector<Wall> box(const Eigen::Vector2d& centre_m, double length_m, double width_m,
                      double phi_rad = 0);

/** A room of 6 x 6 m about the origin. */
std::vector<Wall> squareRoom();

/** A room of 8 x 6 m with a step in a wall, a pillar and a slanted cupboard. It has many corners
 * and no symmetry. */
std::vector<Wall> officeRoom();

/** Two bare walls along x, 2 m apart and 60 m long. The position along x is unobservable. */
std::vector<Wall> corridor();

/** A room of 10 x 8 m with 8 boxes of random size, place and angle. The area within 1.2 m of the
 * origin is free. */
std::vector<Wall> clutteredRoom(unsigned seed);
}  // namespace psmks
