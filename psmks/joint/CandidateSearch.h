/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/joint/PlacesAlong.h>
#include <psmks/joint/PoseJudge.h>
#include <psmks/joint/Refinement.h>

namespace psmks
{
/** Refines starts, one after the other, and keeps the best pose that comes of them. All that were
 * associated well enough are left in JointBuffers::considered. */
class CandidateSearch
{
 public:
  CandidateSearch(JointMatch& match, const PoseJudge& judge, Refinement& refinement)
      : match_(match),
        judge_(judge),
        refinement_(refinement),
        promise_(match.scores, match.guess.T_ref_cur, match.options)
  {
  }

  /** Takes the memory of the widest search for a guess of this kind, so that none takes more. */
  void reserve();

  /** Refines a start and keeps what comes of it if it is the best so far. */
  void consider(const Pose2& start);

  /** Considers what segment angles and line intersections vote for, most promising first, until a
   * pose is convincing. */
  void searchFurther();

  /** Considers poses of a grid, where lines vote for nothing: as far about a guess that nobody
   * measured as the options say, else as far as it may be off, and where that leaves nothing
   * acceptable, as if nobody had measured. One of them has to explain many more rays than an
   * acceptable pose that was found before, or be beyond doubt where it was found despite the guess:
   * rooms look alike from many sides. */
  void searchWide();

  /** Considers starts beside the best pose and at other good places along the same walls: they come
   * back, or they are rivals. */
  void challenge();

  /** Its score is -1 where no start was associated well enough. */
  const RefinedPose& best() const { return best_; }

  /** Associated rays of the start that had most of them. */
  int mostAssociations() const { return mostAssociations_; }

 private:
  struct WideEffort
  {
    WideLimits limits;
    int times;  //!< as many starts as near the guess
  };

  void keepIfBest(const RefinedPose& candidate);
  static Pose2 heard(const RefinedPose& candidate);
  void propose(const SearchLimits& limits);
  void considerMostPromising(int most);
  void searchDespiteGuess();
  void tryGrid(const WideEffort& effort);
  WideEffort withinGuess() const;
  WideEffort farFromGuess() const;
  WideEffort turnedFromGuess() const;
  WideEffort thorough(double radius_m) const;
  void slide();
  void slideAlong(const Eigen::Vector2d& direction);
  void proposeAlong(const Eigen::Vector2d& direction, const AlongLimits& limits);
  AlongLimits nearAlong() const;
  AlongLimits farAlong() const;

  JointMatch& match_;
  const PoseJudge& judge_;
  Refinement& refinement_;
  StartPromise promise_;
  RefinedPose best_;
  int mostAssociations_ = 0;
};
}  // namespace psmks
