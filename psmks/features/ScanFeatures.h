/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/features/Circles.h>
#include <psmks/features/PolarLookup.h>
#include <psmks/features/RayPoints.h>
#include <psmks/geometry/AnchoredLine.h>
#include <psmks/segmentation/SegmentedScan.h>

#include <cstdint>
#include <vector>

namespace psmks
{
/** A scan with everything derived from it that a joint match looks up. */
struct ScanFeatures
{
  const SegmentedScan* scan = nullptr;
  PolarLookup surface;
  RayPoints points;

  std::vector<Segment> lineFeatures;  //!< the segments, in their order, then the short lines
  std::vector<AnchoredLine> lines;    //!< one per straight, in their order, then the patches
  std::vector<int> lineOfRay;         //!< index into lines, or -1
  std::vector<std::uint8_t> movable;  //!< one flag per ray, see MovableObjects.h
  std::vector<Circle> circles;
  std::vector<int> circleOfRay;      //!< index into circles, or -1
  std::vector<int> unsegmentedRays;  //!< valid rays without a segment

  /** Keeps a pointer to the scan. */
  void build(const SegmentedScan& segmented);

 private:
  void findUnsegmentedRays();
};
}  // namespace psmks
