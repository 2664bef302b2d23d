/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/joint/JointMatch.h>
#include <tests/support/Scenes.h>

#include <random>

namespace psmks
{
/** Two scans, segmented, and what a joint match derives from them. */
class JointScene
{
 public:
  /** Exact scans of the same walls, the reference from the origin of the world. */
  JointScene(const std::vector<Wall>& walls, const Pose2& T_ref_cur, const BeamGrid& grid,
             double maxRange_m = 30)
      : JointScene(segmentByWalls(castScan(walls, {}, grid, maxRange_m), walls, {}),
                   segmentByWalls(castScan(walls, T_ref_cur, grid, maxRange_m), walls, T_ref_cur))
  {
  }

  JointScene(SegmentedScan reference, SegmentedScan current)
      : reference_(std::move(reference)), current_(std::move(current))
  {
    buffers.reference.build(reference_);
    buffers.current.build(current_);
  }

  JointScene(const JointScene&) = delete;
  JointScene& operator=(const JointScene&) = delete;

  /** A match of the two scans of which no step was made. */
  JointMatch match(MatchTrace* trace = nullptr)
  {
    return JointMatch(guess, options, nullptr, buffers, trace);
  }

  /** Makes the guess a measurement with these standard deviations. */
  void measureGuess(double sigma_m, double sigma_rad)
  {
    const Eigen::Vector3d sigma(sigma_m, sigma_m, sigma_rad);
    guess.covariance = sigma.cwiseAbs2().asDiagonal();
  }

  ScanScores scores() const
  {
    return ScanScores(buffers.reference, buffers.current, reference_.typicalRangeSigma_m());
  }

  Guess guess;
  JointOptions options;
  JointBuffers buffers;

 private:
  SegmentedScan reference_, current_;
};
}  // namespace psmks
