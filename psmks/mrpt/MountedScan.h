/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <mrpt/obs/CObservation2DRangeScan.h>
#include <psmks/geometry/Pose2.h>
#include <psmks/geometry/Scan.h>
#include <psmks/mrpt/Convert.h>
#include <psmks/mrpt/ScanMatcherOptions.h>

namespace psmks
{
/** A scan and where its scanner sits on the robot: what a trajectory is built of. */
struct MountedScan
{
  Scan scan;
  Pose2 T_robot_sensor;
};

/** Turns an observation into a scan as ScanConverter does, and states how long the sweep took.
 *
 *  @param converter of this scanner
 *  @param options of the mounting: a scan that is tilted by more than `maxTilt_rad` has no valid
 *  ray; `beamTurn_s` is the time in which the beam goes once round, negative where that is against
 *  the order of the observation's rays
 *  @param knownBeamTurn_s the same from elsewhere, used where the options do not state it; 0 =
 *  unknown */
MountedScan toMountedScan(const mrpt::obs::CObservation2DRangeScan& observation,
                          ScanConverter& converter, const ScanMatcherOptions& options,
                          double knownBeamTurn_s = 0);
}  // namespace psmks
