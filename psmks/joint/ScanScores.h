/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/features/FreeSpaceScore.h>
#include <psmks/features/ScanFeatures.h>

namespace psmks
{
/** How well poses explain the rays of two scans by each other's surfaces. */
class ScanScores
{
 public:
  /** @param reference, current are kept by reference
   *  @param rangeSigma_m of the noisier scan */
  ScanScores(const ScanFeatures& reference, const ScanFeatures& current, double rangeSigma_m);

  /** Cheap free-space score of a start that may be off by some centimetres: every fourth ray, one
   * way. */
  double roughScore(const Pose2& T_ref_cur) const;

  /** The same from few rays, with a tolerance of one's own. */
  double scoreWithin(const Pose2& T_ref_cur, double tolerance_m) const;

  /** Rays of both scans against the surfaces of the other: of scans with many rays every second,
   * every third, ..., for a share needs no more. */
  RayCounts allCounts(const Pose2& T_ref_cur) const;

  /** Rays of a scan that lie on surfaces of the other, mean of both scans.
   *  @param counts of allCounts() */
  double inlierRays(const RayCounts& counts) const;

 private:
  const ScanFeatures& reference_;
  const ScanFeatures& current_;
  float tolerance_m_;
};
}  // namespace psmks
