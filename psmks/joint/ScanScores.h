/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/features/FreeSpaceScore.h>
#include <psmks/features/ScanFeatures.h>

namespace psmks
{
/** Scores poses by how well each scan's surfaces explain the rays of the other (FreeSpaceScore.h).
 */
class ScanScores
{
 public:
  /** @param reference, current are kept by reference
   *  @param rangeSigma_m of the noisier scan */
  ScanScores(const ScanFeatures& reference, const ScanFeatures& current, double rangeSigma_m);

  /** Free-space score, 0 to 1, of a start that may be off by some centimetres: every fourth ray of
   * the current scan against the surfaces of the reference, with a tolerance of 15 cm. */
  double roughScore(const Pose2& T_ref_cur) const;

  /** Counts how the rays of either scan lie to the surfaces of the other, within the tolerance of
   * their noise. Of a scan with many rays every second, third, ... is counted, so that some 180
   * remain. */
  RayCounts allCounts(const Pose2& T_ref_cur) const;

  /** Distance within which a point is on a surface. */
  double tolerance_m() const { return static_cast<double>(tolerance_m_); }

  /** Rays of a scan that lie on surfaces of the other, mean of both scans.
   *  @param counts of allCounts() */
  double inlierRays(const RayCounts& counts) const;

 private:
  const ScanFeatures& reference_;
  const ScanFeatures& current_;
  float tolerance_m_;
};
}  // namespace psmks
