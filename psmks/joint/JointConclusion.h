/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/joint/PoseVerifier.h>
#include <psmks/joint/Refinement.h>

namespace psmks
{
/** Accepts or refuses the best pose of a joint match and completes the result: which directions the
 * scans leave open and take from the guess, which other poses explain them as well, how well the
 * pose is known, and whether the scans contradict the guess. MatchResult states the rules. */
class JointConclusion
{
 public:
  /** @param best kept by reference */
  JointConclusion(JointMatch& match, const PoseVerifier& verifier, Refinement& refinement,
                  const RefinedPose& best)
      : match_(match),
        verifier_(verifier),
        refinement_(refinement),
        best_(best),
        result_(match.result)
  {
  }

  /** Completes the result of the match.
   *  @param mostAssociations of any start */
  void conclude(int mostAssociations);

 private:
  void accept();
  void settleHeading();
  bool isHeadingOpen();
  bool convergesElsewhere(double turn_rad);
  bool explainsAsMuch(const RefinedPose& other) const;
  void takeHeadingOfGuess();
  void settleDirection();
  void takePositionOfGuess(const Eigen::Vector2d& direction);
  void settleCovariance();
  void widen(const Eigen::Vector3d& direction, double variance);
  void settleAmbiguity();
  double relativeLikelihood(const RefinedPose& other) const;
  void mixIn(const RefinedPose& other, std::size_t rank, double weight);
  bool isAmbiguousWith(const RefinedPose& other) const;
  Eigen::Vector2d openDirection() const;

  JointMatch& match_;
  const PoseVerifier& verifier_;
  Refinement& refinement_;
  const RefinedPose& best_;
  MatchResult& result_;
  RefinedPose accepted_;   //!< the best pose, or the one at the guess's heading in its place
  NormalEquations scans_;  //!< of the accepted pose, without what is taken from the guess
  std::optional<RefinedPose> turned_;  //!< another heading that explains the scans as well
};
}  // namespace psmks
