/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/slam/PosedScan.h>

#include <cstddef>
#include <vector>

namespace psmks
{
/** A motion by which the odometry is far off what the scans say. */
struct OdometryJump
{
  std::size_t scan = 0;                  //!< at which it was found: index of the scan, from 0 on
  double distance_m = 0, angle_rad = 0;  //!< by which the odometry is off
};

/** The motions between scans that both were matched at which the odometry is off by more than 1 m
 * or 45 degrees, as where it restarts at the origin: no wheels slip so far between two scans. None
 * where the log has no odometry. */
std::vector<OdometryJump> odometryJumps(const std::vector<PosedScan>& scans);
}  // namespace psmks
