/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/segmentation/SegmentedScan.h>

#include <vector>

namespace psmks
{
/** Which wall every ray of a simulated scan met. */
struct WallTruth
{
  static constexpr int kNoWall = -1;
  std::vector<int> wallOfRay;  //!< index into lines, or kNoWall; one per ray
  std::vector<Line> lines;     //!< of the walls, in the sensor frame; covariance not used
};

/** How segments compare with the walls they stand for, over many scans. A segment stands for the
 *  wall that most of its rays met. */
class SegmentationQuality
{
 public:
  void add(const SegmentedScan& scan, const WallTruth& truth);

  /** Share of the valid rays that belong to a segment. */
  double usedShare() const;

  /** Share of these that met the wall of their segment. */
  double rightWallShare() const;

  double segmentsPerScan() const;
  double raysPerSegment() const;

  double offsetMedian_m() const;   //!< of |r0 - true r0|
  double angleMedian_rad() const;  //!< of |phi0 - true phi0|

  /** Mean of the normalised squared error of (r0, phi0): 2 where the covariances are right. */
  double neesMean() const;

  /** Share of the segments whose 95 % ellipse holds the true (r0, phi0). */
  double ellipseShare() const;

 private:
  void addSegment(const Segment& segment, const Line& wall);

  int scans_ = 0;
  int validRays_ = 0, usedRays_ = 0, rightRays_ = 0;
  std::vector<double> offsets_m_, angles_rad_, nees_;
};
}  // namespace psmks
