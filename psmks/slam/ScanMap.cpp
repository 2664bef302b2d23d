/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/segmentation/Segmentation.h>
#include <psmks/slam/MovingReturns.h>
#include <psmks/slam/ScanMap.h>

#include <cstdint>

namespace psmks
{
namespace
{
void addPoints(const SegmentedScan& scan, const std::vector<std::uint8_t>& moving,
               const Pose2& T_world_sensor, ScanMap& map)
{
  for (int ray = 0; ray < scan.rays(); ++ray)
    if (scan.isValid(ray))
      (moving[static_cast<std::size_t>(ray)] ? map.moving_m : map.points_m)
          .push_back(T_world_sensor * scan.point_m(ray));
}

/** How many rays of each segment met what has moved. */
std::vector<int> movingRays(const SegmentedScan& scan, const std::vector<std::uint8_t>& moving)
{
  std::vector<int> count(scan.segments.size(), 0);
  for (std::size_t ray = 0; ray < moving.size(); ++ray)
    if (moving[ray] && scan.segmentOfRay[ray] != SegmentedScan::kNoSegment)
      ++count[static_cast<std::size_t>(scan.segmentOfRay[ray])];
  return count;
}

void addWalls(const SegmentedScan& scan, const std::vector<std::uint8_t>& moving,
              const Pose2& T_world_sensor, ScanMap& map)
{
  const std::vector<int> moved = movingRays(scan, moving);
  for (std::size_t s = 0; s < scan.segments.size(); ++s)
  {
    const Segment& segment = scan.segments[s];
    if (2 * moved[s] > segment.rays) continue;
    map.walls.push_back({T_world_sensor * segment.firstEnd_m, T_world_sensor * segment.lastEnd_m,
                         segment.rays, segment.sigma_m});
  }
}
}  // namespace

ScanMap makeScanMap(const std::vector<PosedScan>& scans, const MatcherOptions& options)
{
  ScanMap map;
  SegmentedScan segmented;
  SegmentationBuffers buffers;
  const bool withOdometry = hasOdometry(scans);
  const MovingReturns movingReturns(scans);
  for (std::size_t s = 0; s < scans.size(); ++s)
  {
    const PosedScan& posed = scans[s];
    const std::vector<std::uint8_t> moving = movingReturns.of(s);
    segmentScan(posed.scan, options.preprocessing, options.segmentation, buffers, segmented);
    addPoints(segmented, moving, posed.T_world_sensor(), map);
    if (posed.isReference) addWalls(segmented, moving, posed.T_world_sensor(), map);
    map.path.push_back(posed.T_world_robot.pose);
    if (withOdometry) map.odometryPath.push_back(posed.T_world_odometry);
  }
  return map;
}
}  // namespace psmks
