/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/segmentation/SegmentedScan.h>

#include <vector>

namespace psmks
{
/** The walls that the rays of a simulated scan met. */
struct WallTruth
{
  static constexpr int kNoWall = -1;
  std::vector<int> wallOfRay;  //!< for each ray an index into lines, or kNoWall
  std::vector<Line> lines;  //!< lines of the walls in the sensor frame; the covariance is not used
};

/** Compares the segments of many scans with the true walls. A segment is compared with the wall
 * that most of its rays met. */
class SegmentationQuality
{
 public:
  void add(const SegmentedScan& scan, const WallTruth& truth);

  /** The share of the valid rays that belong to a segment. */
  double usedShare() const;

  /** The share of the rays in segments that met the wall of their segment. */
  double rightWallShare() const;

  double segmentsPerScan() const;
  double raysPerSegment() const;

  double offsetMedian_m() const;   //!< median of |r0 - true r0|
  double angleMedian_rad() const;  //!< median of |phi0 - true phi0|

  /** The mean normalised squared error of (r0, phi0); 2 if the covariances are right. */
  double neesMean() const;

  /** The share of the segments whose 95 % ellipse contains the true (r0, phi0). */
  double ellipseShare() const;

 private:
  void addSegment(const Segment& segment, const Line& wall);

  int scans_ = 0;
  int validRays_ = 0, usedRays_ = 0, rightRays_ = 0;
  std::vector<double> offsets_m_, angles_rad_, nees_;
};
}  // namespace psmks
