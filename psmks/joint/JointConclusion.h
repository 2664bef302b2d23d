/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/joint/PoseVerifier.h>
#include <psmks/joint/Refinement.h>

namespace psmks
{
/** What the best pose of a joint match is worth: accepts it or fails, finds out what it leaves
 * open, puts that back to the guess, and tells how well the rest is known. */
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
  void settleUnobservable();
  void settleDirection(const Eigen::Vector2d& weakDirection, double weakSigma_m);
  void addAmbiguity();
  bool isAmbiguousWith(const RefinedPose& other) const;
  bool isHeadingOpen();
  bool convergesElsewhere(double turn_rad);
  bool explainsAsMuch(const RefinedPose& other) const;
  void markHeadingUnobservable(double priorInformation);

  JointMatch& match_;
  const PoseVerifier& verifier_;
  Refinement& refinement_;
  const RefinedPose& best_;
  MatchResult& result_;
};
}  // namespace psmks
