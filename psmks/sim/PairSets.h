/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/sim/PairFamily.h>
#include <psmks/sim/WorldIndex.h>

#include <string>
#include <vector>

namespace psmks
{
/** Two simulated scans of one place and their true poses. */
struct SimulatedPair
{
  int id = 0;             //!< its number in the set
  std::size_t world = 0;  //!< index into PairSet::worlds
  Pose2 T_world_ref;      //!< in the middle of the scan, as all poses of a pair
  Pose2 T_ref_cur_true;
  Pose2 T_ref_cur_odometry;
  /** Of the sensor during the scans, each in the axes of the sensor in the middle. */
  PlanarVelocity refVelocity, curVelocity;
  PlanarVelocity refVelocityOdometry, curVelocityOdometry;  //!< measured with noise
  /** At time 0 in the reference scan, kBetweenScans_s in the current one. */
  std::vector<MovingObject> people;
  SimulatedScan reference, current;

  Pose2 T_world_cur() const { return T_world_ref * T_ref_cur_true; }
};

constexpr double kBetweenScans_s = 1;

/** Ratio of the standard deviation of the odometry to the displacement: on each axis to the
 * distance, and of the heading to the rotation; that of velocities accordingly. */
constexpr double kOdometryNoise = 0.05;

/** Least distance of the sensor from all objects at rest, at both scans and on the straight line
 * between them. */
constexpr double kSensorClearance_m = 0.4;

/** Least share of the current scan that the reference sees as well. */
constexpr double kLeastOverlap = 0.4;

/** The pairs of one family. */
struct PairSet
{
  PairFamily family;
  std::vector<WorldIndex> worlds;  //!< without people; used by the pairs in turn
  std::vector<SimulatedPair> pairs;
};

/** Makes pairs of a family. The same seed gives the same bytes, and the first pairs of a set do not
 * depend on how many follow them. Another seed gives other worlds. Sets of one seed that differ in
 * the scanner alone show the same places, as far as people and the overlap allow.
 *
 * The sensor stands at any place that can be reached on foot, with any heading.
 *  @param count >= 0 */
PairSet makePairSet(const PairFamily& family, unsigned seed, int count);
}  // namespace psmks
