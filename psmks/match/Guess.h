/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Pose2.h>

#include <Eigen/Core>
#include <optional>

namespace psmks
{
/** What is known of the pose before a match. */
struct Guess
{
  /** Pose of the current sensor frame in the reference sensor frame, from which the match starts.
   */
  Pose2 T_ref_cur;

  /** Covariance of (x, y, phi) in the axes of the reference frame: m^2, m rad, rad^2; symmetric and
   *  positive definite.
   * Standard deviations above 1 km count as 1 km.
   *
   *  With a covariance the guess is a measurement: the joint scheme uses it as a Gaussian prior in
   *  every step, reports how far the scans are from it (MatchResult::innovation), and gives it up
   *  only where it leaves no acceptable pose (MatchResult::guessGivenUp). Without one the guess is
   *  a starting point: it decides the result only where the scans leave a direction open. The
   *  paper's scheme knows no prior; it takes from a guess what the scans leave open. */
  std::optional<Eigen::Matrix3d> covariance;
};
}  // namespace psmks
