/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/psm/PsmProjection.h>

#include <Eigen/Core>

namespace psmks
{
/** How a match by PsmMatcher ended. In every failure the pose is the guess, or the identity where
 *  that is not finite. */
enum class PsmStatus
{
  NotRun,         //!< a default-constructed result. Failure.
  Converged,      //!< the last steps were small
  MaxIterations,  //!< the iterations ran out first; the method takes the pose as it is
  TooFewPairs,  //!< less than minPairedArc_rad of paired rays, or none in any orientation. Failure.
  Singular,     //!< the pairs do not fix a position. Failure.
  InvalidInput  //!< no good ray in one of the scans, or a guess that is not finite. Failure.
};

/** What a match by PsmMatcher found. */
struct PsmResult
{
  PsmStatus status = PsmStatus::NotRun;
  Pose2 T_ref_cur;
  Eigen::Matrix3d covariance =
      Eigen::Matrix3d::Identity();  //!< of (x, y, phi); of usable ones only
  double errorIndex_m = 0;          //!< see PsmOptions::errorIndex; of usable ones only
  int pairs = 0;                    //!< of the last translation step
  int iterations = 0;               //!< orientation and translation steps

  bool usable() const
  {
    return status == PsmStatus::Converged || status == PsmStatus::MaxIterations;
  }
};

/** Polar scan matching, the method that PSM-KS grew out of: the current scan is projected to the
 *  reference viewpoint, its points pair with the reference points of the same bearing, and
 *  orientation search and translation step alternate until both are small.
 *
 *  Source: Diosi and Kleeman, IROS 2005 and IJRR 2007, see PsmOptions. Orientation goes first, as
 *  in the later edition. The frame is ours: x forward, bearings from it.
 *
 *  Differs from the source: bearings wrap on a closed grid, so a scan of the full circle has no
 *  seam; rotation counts in the stop rule by a limit of its own.
 *
 *  Owns its buffers, so one object serves one thread. Bad data never throws, see PsmStatus. */
class PsmMatcher
{
 public:
  explicit PsmMatcher(PsmOptions options = {}) : options_(options) {}

  const PsmOptions& options() const { return options_; }

  /** Both scans as preparePsmScan() makes them with the same options; their grids may differ. */
  PsmResult match(const PsmScan& reference, const PsmScan& current, const Pose2& T_ref_cur_guess);

 private:
  class Run;

  PsmOptions options_;
  PsmProjection projection_;
  std::vector<double> turnErrors_m_;
};
}  // namespace psmks
