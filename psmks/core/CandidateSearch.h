/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/core/PoseJudge.h>
#include <psmks/core/Refinement.h>

namespace psmks
{
/** Refines starts, one after the other, and keeps the best pose that comes of them. All that were
 * associated well enough are left in JointBuffers::considered. */
class CandidateSearch
{
 public:
  CandidateSearch(JointMatch& match, const PoseJudge& judge, Refinement& refinement)
      : match_(match), judge_(judge), refinement_(refinement)
  {
  }

  /** Refines a start and keeps what comes of it if it is the best so far. */
  void consider(const Pose2& start);

  /** Considers what segment angles and line intersections vote for, most promising first, until a
   * pose is convincing. */
  void searchFurther();

  /** Considers poses farther from the guess than searchFurther() does. One of them has to explain
   * many more rays than an acceptable pose near the guess: rooms look alike from many sides. */
  void searchWide();

  /** Considers starts beside the best pose and at other good places along the same walls: they come
   * back, or they are rivals. */
  void challenge();

  /** Its score is -1 where no start was associated well enough. */
  const RefinedPose& best() const { return best_; }

  /** Associated rays of the start that had most of them. */
  int mostAssociations() const { return mostAssociations_; }

 private:
  void keepIfBest(const RefinedPose& candidate);
  static Pose2 heard(const RefinedPose& candidate);
  void propose(const SearchLimits& limits);
  void considerMostPromising(int most);
  void slide();
  void findPlacesAlong();
  double promise(const Pose2& T_ref_cur) const;

  JointMatch& match_;
  const PoseJudge& judge_;
  Refinement& refinement_;
  RefinedPose best_;
  int mostAssociations_ = 0;
};
}  // namespace psmks
