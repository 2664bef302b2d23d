/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/sim/PairFamily.h>
#include <psmks/sim/WorldIndex.h>

#include <string>
#include <vector>

namespace psmks
{
/** Two simulated scans of one place, with the truth. */
struct SimulatedPair
{
  int id = 0;             //!< its place in the set
  std::size_t world = 0;  //!< index into PairSet::worlds
  Pose2 T_world_ref;
  Pose2 T_ref_cur_true;
  Pose2 T_ref_cur_odometry;
  std::vector<MovingObject> people;  //!< at time 0 in the reference, kBetweenScans_s in the current
  SimulatedScan reference, current;

  Pose2 T_world_cur() const { return T_world_ref * T_ref_cur_true; }
};

constexpr double kBetweenScans_s = 1;

/** Of the odometry's error to the displacement: per axis to the distance, and to the rotation. */
constexpr double kOdometryNoise = 0.05;

/** The sensor keeps this distance to all that stands, at both scans and on the way between. */
constexpr double kSensorClearance_m = 0.4;

/** Share of the current scan that the reference sees too, at least. */
constexpr double kLeastOverlap = 0.4;

/** Pairs of one family. */
struct PairSet
{
  PairFamily family;
  std::vector<WorldIndex> worlds;  //!< without people; the pairs take them in turn
  std::vector<SimulatedPair> pairs;
};

/** So many pairs of a family. The same seed gives the same bytes, and the first pairs of a set do
 * not depend on how many follow; another seed gives other worlds. Sets of one seed that only differ
 * in the scanner show the same places as far as people and overlap allow.
 *
 * The sensor stands anywhere that one can walk to, heading anywhere.
 *  @param count >= 0 */
PairSet makePairSet(const PairFamily& family, unsigned seed, int count);
}  // namespace psmks
