/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/support/LogScan.h>
#include <mrpt/slam/CMetricMapsAlignmentAlgorithm.h>
#include <psmks/motion/OdometryNoise.h>
#include <psmks/slam/PosedScan.h>

#include <vector>

namespace psmks
{
/** When a scan is added to the map: the robot has moved or turned so far since the last one. */
struct MapGrowth
{
  double distance_m = 1;
  double angle_rad = 0;
};

/** How a log was followed by aligning its scans to a point map. */
struct MapAlignment
{
  std::vector<PosedScan> scans;  //!< where the alignments, or the odometry, put them
  int alignments = 0;
  int refused = 0;         //!< with a goodness of at most 0.4, the threshold of MRPT's map builders
  int moved = 0;           //!< accepted, and more than 0.5 m from the prediction
  double alignment_s = 0;  //!< time of all alignments
};

/** Follows a robot as mrpt::slam::CMetricMapBuilderICP does: the odometry predicts, the point map
 * of the scan is aligned to that of the scans so far, and the scan is added where the robot has
 * moved far enough. A refused alignment leaves the prediction.
 *  @param odometry makes the covariance of the prediction; a log without odometry has none */
MapAlignment followByMap(const std::vector<LogScan>& scans,
                         mrpt::slam::CMetricMapsAlignmentAlgorithm& algorithm,
                         const MapGrowth& growth, const OdometryOptions& odometry);
}  // namespace psmks
