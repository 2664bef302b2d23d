/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/segmentation/SegmentedScan.h>

#include <cstdint>
#include <vector>

namespace psmks
{
/** End points of the valid rays of a scan, one array a coordinate. */
struct RayPoints
{
  std::vector<float> x_m, y_m;
  std::vector<std::uint8_t> movable;  //!< of each point, see MovableObjects.h

  /** @param movableRays one flag per ray; empty = none */
  void build(const SegmentedScan& scan, const std::vector<std::uint8_t>& movableRays = {});

  std::size_t size() const { return x_m.size(); }

 private:
  void keepValid(const std::vector<std::uint8_t>& valid);
};
}  // namespace psmks
