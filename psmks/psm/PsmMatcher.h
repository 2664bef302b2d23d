/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/psm/PsmProjection.h>

#include <Eigen/Core>

namespace psmks
{
/** How a match by PsmMatcher ended. After a failure the pose is the guess, or the identity if the
 * guess is not finite. */
enum class PsmStatus
{
  NotRun,         //!< the value of a default-constructed result. Failure.
  Converged,      //!< the last steps were small
  MaxIterations,  //!< the iterations ran out before; the method accepts the pose
  TooFewPairs,    //!< paired rays cover less than minPairedArc_rad, or none pair. Failure.
  Singular,       //!< the pairs do not determine a position. Failure.
  InvalidInput    //!< a scan has no good ray, or the guess is not finite. Failure.
};

/** The result of a match by PsmMatcher. */
struct PsmResult
{
  PsmStatus status = PsmStatus::NotRun;
  Pose2 T_ref_cur;
  /** Of (x, y, phi); set if the match is usable. */
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
  double errorIndex_m = 0;  //!< see PsmOptions::errorIndex; set if the match is usable
  int pairs = 0;            //!< number of pairs in the last translation step
  int iterations = 0;       //!< number of orientation and translation steps

  bool usable() const
  {
    return status == PsmStatus::Converged || status == PsmStatus::MaxIterations;
  }
};

/** Polar scan matching (PSM), the method from which PSM-KS was developed. The current scan is
 * projected to the reference viewpoint, and its points are paired with the reference points at the
 * same bearing. An orientation search and a translation step alternate until both changes are
 * small.
 *
 * Source: Diosi and Kleeman, IROS 2005 and IJRR 2007, see PsmOptions. The orientation search comes
 * first, as in the later paper. Frames are those of psmks: x forward, bearings counted from it.
 *
 * Differs from the source: bearings wrap on a closed grid, so that a scan of the full circle has no
 * seam, and the stop rule has a separate limit for the rotation.
 *
 * An object owns its buffers and serves one thread. Bad data never throws, see PsmStatus. */
class PsmMatcher
{
 public:
  explicit PsmMatcher(PsmOptions options = {}) : options_(options) {}

  const PsmOptions& options() const { return options_; }

  /** Matches two scans that preparePsmScan() made with the options of this matcher. Their grids may
   * differ. */
  PsmResult match(const PsmScan& reference, const PsmScan& current, const Pose2& T_ref_cur_guess);

 private:
  class Run;

  PsmOptions options_;
  PsmProjection projection_;
  std::vector<double> turnErrors_m_;
};
}  // namespace psmks
