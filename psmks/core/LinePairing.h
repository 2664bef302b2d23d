/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/core/AnchoredLine.h>
#include <psmks/core/Circles.h>
#include <psmks/core/JointProblem.h>
#include <psmks/core/PolarSurface.h>
#include <psmks/core/RayPoints.h>
#include <psmks/core/SegmentedScan.h>

#include <vector>

namespace psmks
{
/** A scan with everything derived from it that a joint match looks up. */
struct MatchView
{
  const SegmentedScan* scan = nullptr;
  PolarSurface surface;
  RayPoints points;

  std::vector<Segment> straights;     //!< the segments, in their order, then the short lines
  std::vector<AnchoredLine> lines;    //!< one per straight, in their order, then the patches
  std::vector<int> lineOfRay;         //!< index into lines, or -1
  std::vector<std::uint8_t> movable;  //!< one flag per ray, see FreeStanding.h
  std::vector<Circle> circles;
  std::vector<int> circleOfRay;  //!< index into circles, or -1
  std::vector<int> singles;      //!< valid rays without a segment

  /** Keeps a pointer to the scan. */
  void build(const SegmentedScan& segmented);

 private:
  void findSingles();
};

/** Gates of an association. */
struct PairingGates
{
  double distance_m;
  double angle_rad;
  double singleRayWeight;
  double singleRaySlack_m = 0;  //!< standard deviation added to the distances of single rays
  bool fine = false;  //!< whether short lines and circles are paired, their rays then being none
};

/** Associates lines, circles and single rays of two scans at a pose and appends them to a problem.
 *
 * Lines (paper, section 2.1): a current segment goes with every reference segment that it covers
 * when seen from the reference viewpoint, where both stand within the gates over the rays they
 * share and are seen from the same side. So do short
 * lines and circles where the gates ask for them; segments that are part of an arc then do not.
 * Single rays, in both directions: with the segment or
 * patch of the other scan at their bearing, of two at a boundary the nearer.
 *
 * Differs from the paper: whole lines are compared with the covariances of both, instead of the
 * rays of one with the line of the other; the common error of a reference line is then counted
 * once.
 *
 * @return associated rays */
int pairLines(const MatchView& reference, const MatchView& current, const Pose2& T_ref_cur,
              const PairingGates& gates, JointProblem& problem);
}  // namespace psmks
