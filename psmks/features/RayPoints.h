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

  /** Independent looks that each point stands for, at most 1: the length of the surface between two
   * returns at its range, kLook_m being one look. Two rays on one object see the same thing: of a
   * person close by they are many, and say no more than the few on one far away. */
  std::vector<float> looks;

  /** Length of a surface that is one independent look. Evidence: with rays counted alike, 31 % of
   * the best wrong poses among six people score more than the lowest fiftieth of the right ones,
   * and 17 % of every second scan of the MIT CSAIL log (`csail`); with looks of 0.1 m 14 and 6 %,
   * of 0.25 m 15 and 5 %, of 0.5 m 15 and 5 %. */
  static constexpr float kLook_m = 0.25f;

  /** Replaces the points by those of a scan, in the order of its rays.
   *  @param movableRays one flag per ray; empty where no ray is on a movable object */
  void build(const SegmentedScan& scan, const std::vector<std::uint8_t>& movableRays = {});

  std::size_t size() const { return x_m.size(); }

 private:
  void keepValid(const std::vector<std::uint8_t>& valid);
};
}  // namespace psmks
