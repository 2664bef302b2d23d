/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/segmentation/Segmentation.h>
#include <psmks/slam/ScanMap.h>

namespace psmks
{
namespace
{
void addPoints(const SegmentedScan& scan, const Pose2& T_world_sensor, ScanMap& map)
{
  for (int ray = 0; ray < scan.rays(); ++ray)
    if (scan.isValid(ray)) map.points_m.push_back(T_world_sensor * scan.point_m(ray));
}

void addWalls(const SegmentedScan& scan, const Pose2& T_world_sensor, ScanMap& map)
{
  for (const auto& segment : scan.segments)
    map.walls.push_back({T_world_sensor * segment.firstEnd_m, T_world_sensor * segment.lastEnd_m,
                         segment.rays, segment.sigma_m});
}
}  // namespace

ScanMap makeScanMap(const std::vector<PosedScan>& scans, const MatcherOptions& options)
{
  ScanMap map;
  SegmentedScan segmented;
  SegmentationBuffers buffers;
  const bool withOdometry = hasOdometry(scans);
  for (const auto& posed : scans)
  {
    segmentScan(posed.scan, options.preprocessing, options.segmentation, buffers, segmented);
    addPoints(segmented, posed.T_world_sensor(), map);
    if (posed.isReference) addWalls(segmented, posed.T_world_sensor(), map);
    map.path.push_back(posed.T_world_robot.pose);
    if (withOdometry) map.odometryPath.push_back(posed.T_world_odometry);
  }
  return map;
}
}  // namespace psmks
