/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/segmentation/SegmentedScan.h>

#include <cstdint>
#include <vector>

namespace psmks
{
/** End points of the valid rays of a scan as a structure of arrays. */
struct RayPoints
{
  std::vector<float> x_m, y_m;        //!< coordinates in the sensor frame, one per point
  std::vector<std::uint8_t> movable;  //!< one flag per point, see findMovableObjects()

  /** Replaces the points by those of a scan, in the order of its rays.
   *  @param movableRays one flag per ray; empty where no ray is on a movable object */
  void build(const SegmentedScan& scan, const std::vector<std::uint8_t>& movableRays = {});

  std::size_t size() const { return x_m.size(); }

 private:
  void keepValid(const std::vector<std::uint8_t>& valid);
};
}  // namespace psmks
