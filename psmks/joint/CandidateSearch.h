/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/joint/PoseVerifier.h>
#include <psmks/joint/Refinement.h>
#include <psmks/joint/WeakDirectionSearch.h>

namespace psmks
{
/** Refines starts, one after the other, and keeps the best pose that comes of them. All that were
 * associated well enough are left in JointBuffers::refinedPoses. */
class CandidateSearch
{
 public:
  CandidateSearch(JointMatch& match, const PoseVerifier& verifier, Refinement& refinement)
      : match_(match),
        verifier_(verifier),
        refinement_(refinement),
        hypothesisScore_(match.scores, match.guess.T_ref_cur, match.options)
  {
  }

  /** Takes the memory of the widest search for a guess of this kind, so that none takes more. */
  void reserve();

  /** Refines a start and keeps what comes of it if it is the best so far. */
  void refineAndKeep(const Pose2& start);

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
  void probeAlternatives();

  /** Its score is -1 where no start was associated well enough. */
  const RefinedPose& best() const { return best_; }

  /** Associated rays of the start that had most of them. */
  int mostAssociations() const { return mostAssociations_; }

 private:
  struct SearchWindow
  {
    CorrelativeLimits limits;
    int times;  //!< as many starts as near the guess
  };

  void keepIfBest(const RefinedPose& candidate);
  static Pose2 rotatedToBestLinePair(const RefinedPose& candidate);
  void propose(const SearchLimits& limits);
  void considerMostPromising(int most);
  void searchDespiteGuess();
  void tryGrid(const SearchWindow& effort);
  SearchWindow withinGuess() const;
  SearchWindow farFromGuess() const;
  SearchWindow turnedFromGuess() const;
  SearchWindow exhaustiveWindow(double radius_m) const;
  void searchAlongWeakDirections();
  void searchAlong(const Eigen::Vector2d& direction);
  void proposeAlong(const Eigen::Vector2d& direction, const AlongLimits& limits);
  AlongLimits nearAlong() const;
  AlongLimits farAlong() const;

  JointMatch& match_;
  const PoseVerifier& verifier_;
  Refinement& refinement_;
  HypothesisScore hypothesisScore_;
  RefinedPose best_;
  int mostAssociations_ = 0;
};
}  // namespace psmks
