/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/base/Stopwatch.h>
#include <psmks/joint/Refinement.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace psmks
{
namespace
{
/** Holds an estimate near the start of an association where the guess was not measured, so weakly
 * that it acts only along what the scans do not fix: there the estimate would wander with the
 * noise. */
PriorTerm startPrior(const Pose2& start)
{
  /** Standard deviations of the pull towards the start of an association. Evidence: measured. */
  constexpr double kSigma_m = 0.3, kSigma_rad = degToRad(20);
  const Eigen::Vector3d information(1 / (kSigma_m * kSigma_m), 1 / (kSigma_m * kSigma_m),
                                    1 / (kSigma_rad * kSigma_rad));
  return {start, information.asDiagonal()};
}
}  // namespace

RefinedPose Refinement::refine(const Pose2& start, double firstShare)
{
  Stopwatch watch;
  RefinedPose pose = alternate(start, firstShare);
  match_.result.times.refinement_s += watch.lap_s();
  if (hasTooFew(pose)) return pose;
  score(pose);
  match_.result.times.scoring_s += watch.lap_s();
  return pose;
}

/** Rounds of association and Gauss-Newton, as refine() states. */
RefinedPose Refinement::alternate(const Pose2& start, double firstShare)
{
  /** Width of the gates of the last association. Unit: share of the first gates. Evidence:
   * measured. */
  constexpr double kLastShare = 0.25;

  /** Motion below which a pose has settled. Unit: share of the gates. Evidence: measured. */
  constexpr double kSettled = 0.05;

  /** Most repeats of the last association. Unit: repeats. Evidence: measured. */
  constexpr int kMostRepeats = 6;
  const int rounds = match_.options.reassociations;
  RefinedPose pose;
  pose.T_ref_cur = start;
  for (int round = 0; round + 1 < rounds; ++round)
  {
    const double share = std::ldexp(firstShare, -round);
    const Pose2 motion = associate(share, false, pose);
    if (hasTooFew(pose)) return pose;
    if (isWithin(motion, share * kSettled)) break;
  }
  const double lastShare = rounds > 1 ? kLastShare : firstShare;
  for (int repeat = 0; repeat <= kMostRepeats; ++repeat)
  {
    const Pose2 motion = associate(lastShare, true, pose);
    if (hasTooFew(pose) || isWithin(motion, lastShare * kSettled)) break;
  }
  return pose;
}

/** One association and the pose that follows from it.
 *  @param share of the gates
 *  @param last whether to pair short lines and circles too, and to settle to the end
 *  @return the motion of the pose */
Pose2 Refinement::associate(double share, bool last, RefinedPose& pose)
{
  /** Standard deviation that single rays are given besides their noise in all associations but the
   * last. Whole lines lead the way there, for many single rays lie on other objects than their
   * partners. Unit: share of the gate. Evidence: among people 94 % of the pairs are found without
   * it and 96.5 % with it; docs/tried.md. */
  constexpr double kSlack = 0.1;
  const JointOptions& options = match_.options;
  PairingGates gates{distanceGate_m(share), share * options.angleGate_rad, options.singleRayWeight};
  gates.unsegmentedRaySlack_m = last ? 0 : kSlack * gates.distance_m;
  gates.edgeDistance_m = last ? options.distanceGate_m : 0;
  gates.pairShortLinesAndCircles = last;
  const Pose2 before = pose.T_ref_cur;
  JointBuffers& buffers = match_.buffers;
  JointProblem& problem = buffers.problem;
  problem.clear();
  problem.kernelWidth = options.kernelWidth;
  problem.prior = match_.prior() ? *match_.prior() : startPrior(before);
  pose.associations = associateFeatures(buffers.reference, buffers.current, before, gates, problem);
  if (hasTooFew(pose)) return {};
  pose.converged = solve(last ? finalLimits() : limitsWithin(gates), pose.T_ref_cur);
  return before.inverse() * pose.T_ref_cur;
}

/** This share of the gate, but no less than what noise alone moves the lines of one wall apart: a
 * narrower gate would leave of a noisy scan what happens to fit. Noise that grows with the range
 * does not count, for gates are for the near walls too. */
double Refinement::distanceGate_m(double share) const
{
  /** Smallest gate. Unit: standard deviations of a short range. Evidence: with 30 cm of noise the
   * mean error of the map is 0.24 m with 0, 0.13 m with 1.5 and 0.14 m with 3; docs/tried.md. */
  constexpr double kNoise = 1.5;
  const JointBuffers& buffers = match_.buffers;
  const double sigma_m = std::max(buffers.reference.scan->rangeNoise.sigma_m,
                                  buffers.current.scan->rangeNoise.sigma_m);
  return std::max(share * match_.options.distanceGate_m, kNoise * sigma_m);
}

bool Refinement::solve(const SolverLimits& limits, Pose2& T_ref_cur)
{
  const JointProblem& problem = match_.buffers.problem;
  if (match_.options.solver == JointSolver::Ceres)
    return match_.external->solveJoint(problem, T_ref_cur);
  const JointSolution solution = solveByGaussNewton(problem, limits, T_ref_cur);
  match_.result.iterations += solution.iterations;
  return solution.converged;
}

/** What the scans, and the associations made last, say of a pose. */
void Refinement::score(RefinedPose& pose) const
{
  const JointProblem& problem = match_.buffers.problem;
  const RayCounts counts = match_.scores.allCounts(pose.T_ref_cur);
  pose.score = freeSpaceScore(counts);
  pose.inlierRays = match_.scores.inlierRays(counts);
  pose.scans = linearise(problem, pose.T_ref_cur, false);
  pose.observability = observability(pose.scans.H);
  if (match_.prior())
    pose.innovation = innovation({match_.guess.T_ref_cur, *match_.guess.covariance}, pose.T_ref_cur,
                                 pose.scans.H, pose.scans.g);
  pose.logPosterior = logLikelihoodRatio(counts) + match_.logPrior(pose);
  pose.angleVariance_rad2 = bestAngleVariance_rad2();
}

/** The variance of the angle between the two lines whose directions are known best. */
double Refinement::bestAngleVariance_rad2() const
{
  double variance_rad2 = std::numeric_limits<double>::infinity();
  for (const LinePairTerm& pair : match_.buffers.problem.linePairs)
    variance_rad2 = std::min(variance_rad2, pair.angleVariance_rad2);
  return variance_rad2;
}

bool Refinement::hasTooFew(const RefinedPose& pose) const
{
  return pose.associations < match_.options.minAssociations;
}

/** Whether a motion is small beside this share of the gates. */
bool Refinement::isWithin(const Pose2& motion, double share) const
{
  return motion.translation().norm() < share * match_.options.distanceGate_m &&
         std::abs(motion.phi_rad) < share * match_.options.angleGate_rad;
}

SolverLimits Refinement::finalLimits() const
{
  const JointOptions& options = match_.options;
  return {options.maxIterations, options.stopTranslation_m, options.stopRotation_rad};
}

/** Before another association, with narrower gates, a pose need not settle to the end. */
SolverLimits Refinement::limitsWithin(const PairingGates& gates) const
{
  /** Step at which Gauss-Newton stops before another association. Unit: share of the gates.
   * Evidence: a twentieth saves no time and makes the drift along corridors 1.5 times as large;
   * docs/tried.md. */
  constexpr double kShare = 0.01;
  const SolverLimits last = finalLimits();
  return {last.maxIterations, std::max(last.stopTranslation_m, kShare * gates.distance_m),
          std::max(last.stopRotation_rad, kShare * gates.angle_rad)};
}
}  // namespace psmks
