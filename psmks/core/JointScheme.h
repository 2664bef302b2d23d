/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/core/ExternalSolvers.h>
#include <psmks/core/Guess.h>
#include <psmks/core/Hypotheses.h>
#include <psmks/core/JointOptions.h>
#include <psmks/core/MatchResult.h>
#include <psmks/core/MatchTrace.h>
#include <psmks/core/Observability.h>
#include <psmks/core/SegmentedScan.h>

#include <vector>

namespace psmks
{
/** A start that went through Gauss-Newton. */
struct RefinedPose
{
  Pose2 T_ref_cur;
  double score = -1;
  int associations = 0;
  double raysOn = 0;  //!< rays of a scan that lie on surfaces of the other, mean of both
  bool converged = false;
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  //!< of the scans alone
  Observability observability;
  double angleVariance_rad2 = 0;  //!< of the pair of lines whose directions are known best
};

/** The buffers of a joint match, kept from one to the next. */
struct JointBuffers
{
  MatchView reference, current;
  HypothesisSearch search;
  std::vector<Hypothesis> hypotheses;
  std::vector<RefinedPose> considered;
  JointProblem problem;
};

/** Matches two scans by the joint scheme (docs/algorithm.md):
 *
 *  1. Refine the guess: associate lines and single rays, Gauss-Newton over x, y, theta, again with
 *     narrower gates.
 *  2. Score the result by free space. Where it is not convincing, let segment angles and line
 *     intersections vote for other starts and refine those, most promising first.
 *  3. Accept the pose with the best score if that is high enough; find out what it leaves open.
 *
 * @param external null unless options.solver is Ceres
 * @param trace may be null */
MatchResult matchByJointScheme(const SegmentedScan& reference, const SegmentedScan& current,
                               const Guess& guess, const JointOptions& options,
                               const ExternalSolvers* external, JointBuffers& buffers,
                               MatchTrace* trace);
}  // namespace psmks
