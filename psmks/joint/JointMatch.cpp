/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/joint/JointMatch.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>

namespace psmks
{
JointMatch::JointMatch(const Guess& guess_, const JointOptions& options_,
                       const ExternalSolvers* external_, JointBuffers& buffers_, MatchTrace* trace_)
    : guess(guess_),
      options(options_),
      external(external_),
      buffers(buffers_),
      trace(trace_),
      rangeSigma_m(std::max(buffers_.reference.scan->typicalRangeSigma_m(),
                            buffers_.current.scan->typicalRangeSigma_m())),
      scores(buffers_.reference, buffers_.current,
             std::max({rangeSigma_m, buffers_.reference.scan->shownRangeSigma_m(),
                       buffers_.current.scan->shownRangeSigma_m()}))
{
  result.T_ref_cur = guess.T_ref_cur;
  if (!guess.covariance) return;
  result.covariance = *guess.covariance;
  guessPrior_ = {guess.T_ref_cur, guess.covariance->inverse()};
}

double JointMatch::logPrior(const RefinedPose& pose) const
{
  if (prior()) return -0.5 * pose.innovation.chi2;
  const Pose2& T = pose.T_ref_cur;
  const Eigen::Vector3d fromGuess(T.x_m - guess.T_ref_cur.x_m, T.y_m - guess.T_ref_cur.y_m,
                                  wrapAngle(T.phi_rad - guess.T_ref_cur.phi_rad));
  return -0.5 * fromGuess.dot(MatchResult::unknownCovariance().ldlt().solve(fromGuess));
}
}  // namespace psmks
