/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <mrpt/obs/CObservation2DRangeScan.h>
#include <psmks/geometry/BeamTiming.h>
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

/** Turns an observation into a scan as ScanConverter does, and states when its rays were cast.
 *
 *  @param converter of this scanner
 *  @param options of the mounting: a scan that is tilted by more than `maxTilt_rad` has no valid
 *  ray; `beam` states when the rays are cast, its time of a turn being negative where the beam
 * passes the rays of the observation from the last to the first
 *  @param known the same from elsewhere, used where the options do not state the time of a turn */
MountedScan toMountedScan(const mrpt::obs::CObservation2DRangeScan& observation,
                          ScanConverter& converter, const ScanMatcherOptions& options,
                          const BeamTiming& known = {});
}  // namespace psmks
