/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/features/Circles.h>
#include <psmks/features/DepthEdges.h>
#include <psmks/features/PolarLookup.h>
#include <psmks/features/RayPoints.h>
#include <psmks/geometry/AnchoredLine.h>
#include <psmks/segmentation/SegmentedScan.h>

#include <cstdint>
#include <vector>

namespace psmks
{
/** A segmented scan with all features that the joint scheme pairs and scores. */
struct ScanFeatures
{
  /** The scan that the features were found in. */
  const SegmentedScan* scan = nullptr;

  /** The surfaces that the scan saw, for the free-space score. */
  PolarLookup surface;

  /** The end points of the valid rays, for the free-space score. */
  RayPoints points;

  /** The segments of the scan, in their order, and after them the short lines. */
  std::vector<Segment> lineFeatures;

  /** One line for each line feature, in their order, and after them the surfels. */
  std::vector<AnchoredLine> lines;

  /** Index into `lines` for each ray, or -1. */
  std::vector<int> lineOfRay;

  /** One flag per ray: whether it has a return, or is in a hole of a segment
   * (SegmentedScan::longestHole()). */
  std::vector<std::uint8_t> hasSurface;

  /** One flag per ray, see findMovableObjects(). */
  std::vector<std::uint8_t> movable;

  /** The circles, see findCircles(). */
  std::vector<Circle> circles;

  /** Index into `circles` for each ray, or -1. */
  std::vector<int> circleOfRay;

  /** The ends of objects, see findDepthEdges(). */
  std::vector<DepthEdge> edges;

  /** Indices of the valid rays without a segment. */
  std::vector<int> unsegmentedRays;

  /** Finds all features of a scan. Keeps a pointer to the scan, which has to outlive this object's
   * use. Allocates only where the scan has more of a feature than any scan before. */
  void build(const SegmentedScan& segmented);

 private:
  void findUnsegmentedRays();
  void closeHoles();
};
}  // namespace psmks
