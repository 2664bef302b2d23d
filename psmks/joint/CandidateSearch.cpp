/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/base/Stopwatch.h>
#include <psmks/joint/CandidateSearch.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
Pose2 moved(const Pose2& T, const Eigen::Vector2d& by_m)
{
  return {T.x_m + by_m.x(), T.y_m + by_m.y(), T.phi_rad};
}
}  // namespace

void CandidateSearch::refineAndKeep(const Pose2& start)
{
  /** Width of the first gates of a second refinement. Unit: share of the gates. Evidence: none of
   * its own; it was chosen with the scheme as a whole. */
  constexpr double kNarrow = 0.5;
  ++match_.result.hypotheses;
  const RefinedPose candidate = refinement_.refine(start);
  keepIfBest(candidate);
  if (candidate.bestPairAngleResidual_rad != 0)
    keepIfBest(refinement_.refine(rotatedToBestLinePair(candidate), kNarrow));
  const bool canNarrow = match_.options.reassociations > 1 && candidate.score > 0;
  if (!canNarrow || verifier_.isConvincing(candidate)) return;
  if (freeSpaceScore(match_.scores.allCounts(start)) > candidate.score)
    keepIfBest(refinement_.refine(start, kNarrow));
}

/** The pose turned so that no angle is left between the two lines that know the heading best. */
Pose2 CandidateSearch::rotatedToBestLinePair(const RefinedPose& candidate)
{
  Pose2 T = candidate.T_ref_cur;
  T.phi_rad = wrapAngle(T.phi_rad - candidate.bestPairAngleResidual_rad);
  return T;
}

void CandidateSearch::keepIfBest(const RefinedPose& candidate)
{
  mostAssociations_ = std::max(mostAssociations_, candidate.associations);
  if (candidate.associations < match_.options.minAssociations) return;
  if (match_.trace)
    match_.trace->steps.push_back({"refinement", candidate.T_ref_cur, std::nullopt, candidate.score,
                                   candidate.associations, 0});
  match_.buffers.refinedPoses.push_back(candidate);
  if (best_.score > 0 && verifier_.rankingScore(candidate) <= verifier_.rankingScore(best_)) return;
  best_ = candidate;
}

void CandidateSearch::searchFurther()
{
  const JointOptions& options = match_.options;
  match_.buffers.hypotheses.clear();
  propose({options.searchRadius_m, options.searchAngle_rad, options.votedAngles});
  if (match_.result.hypotheses == 0)
    match_.buffers.hypotheses.push_back({match_.guess.T_ref_cur, 0, 0});
  refineBest(options.refinedHypotheses);
  /** Share of the rays that has to be paired before places along a wall are searched. Unit: share
   * of the rays. Evidence: none of its own; it was chosen with the scheme as a whole. */
  constexpr double kEnough = 0.25;
  if (!match_.prior() && !verifier_.isConvincing(best_) && match_.pairsMoreThan(kEnough, best_))
    searchAlongWeakDirections();
}

void CandidateSearch::reserve()
{
  const JointOptions& o = match_.options;
  const double radius_m = match_.prior() ? o.searchRadius_m : o.wideRadius_m;
  match_.buffers.correlativeSearch.reserve(radius_m, std::max(o.searchAngle_rad, o.wideAngle_rad));
  match_.buffers.hypotheses.reserve(mostPlacesAlong(std::max(o.searchRadius_m, o.wideRadius_m)));
}

void CandidateSearch::searchWide()
{
  /** What a far pose has to explain more than an acceptable one near the guess. Unit: score.
   * Evidence: none of its own; it was chosen with the scheme as a whole. */
  constexpr double kMoreFarOff = 0.1;
  const RefinedPose nearGuess = best_;
  tryGrid(match_.prior() ? withinGuess() : farFromGuess());
  if (verifier_.isAcceptable(nearGuess) && best_.score < nearGuess.score + kMoreFarOff)
    best_ = nearGuess;
  if (match_.prior() && !verifier_.isAcceptable(best_)) searchDespiteGuess();
}

/** Where wheels have slipped, the guess is no measurement of the motion: it is given up for a pose
 * that is beyond doubt without it. */
void CandidateSearch::searchDespiteGuess()
{
  const RefinedPose nearGuess = best_;
  const int mostNearGuess = mostAssociations_;
  match_.result.guessGivenUp = true;
  tryGrid(turnedFromGuess());
  if (verifier_.isBeyondDoubt(best_)) return;
  best_ = nearGuess;
  mostAssociations_ = mostNearGuess;
  match_.result.guessGivenUp = false;
}

void CandidateSearch::tryGrid(const SearchWindow& window)
{
  Stopwatch watch;
  JointBuffers& buffers = match_.buffers;
  buffers.correlativeSearch.propose(match_.scores, match_.guess.T_ref_cur, window.limits,
                                    buffers.hypotheses);
  match_.result.times.search_s += watch.lap_s();
  refineBest(window.refinementBudgetFactor * match_.options.refinedHypotheses);
}

/** The search window of a guess with a covariance: three standard deviations, at most what is
 * searched for votes. */
CandidateSearch::SearchWindow CandidateSearch::withinGuess() const
{
  /** Size of the grid about a measured guess. Unit: standard deviations. Evidence: none of its own;
   * it was chosen with the scheme as a whole. */
  constexpr double kSigmas = 3;

  /** Points of that grid that climb. Unit: points. Evidence: none of its own; it was chosen with
   * the scheme as a whole. */
  constexpr std::size_t kFollowed = 16;
  const JointOptions& o = match_.options;
  const Eigen::Matrix3d& C = *match_.guess.covariance;
  return {{std::min(o.searchRadius_m, kSigmas * std::sqrt(std::max(C(0, 0), C(1, 1)))),
           std::min(o.searchAngle_rad, kSigmas * std::sqrt(C(2, 2))), kFollowed},
          1};
}

CandidateSearch::SearchWindow CandidateSearch::farFromGuess() const
{
  return exhaustiveWindow(match_.options.wideRadius_m);
}

/** The window for a guess that is given up: wheels that slip turn a guess far more than they move
 * it. */
CandidateSearch::SearchWindow CandidateSearch::turnedFromGuess() const
{
  return exhaustiveWindow(match_.options.searchRadius_m);
}

CandidateSearch::SearchWindow CandidateSearch::exhaustiveWindow(double radius_m) const
{
  /** Points of the exhaustive grid that climb. Unit: points. Evidence: none of its own; it was
   * chosen with the scheme as a whole. */
  constexpr std::size_t kFollowed = 80;

  /** How many times as many hypotheses are refined as near the guess. Unit: ratio. Evidence: none
   * of its own; it was chosen with the scheme as a whole. */
  constexpr int kTimes = 3;
  return {{radius_m, match_.options.wideAngle_rad, kFollowed}, kTimes};
}

/** Appends the poses that segment angles and line intersections vote for to the hypotheses. */
void CandidateSearch::propose(const SearchLimits& limits)
{
  Stopwatch watch;
  JointBuffers& buffers = match_.buffers;
  buffers.search.propose(buffers.reference, buffers.current, match_.guess.T_ref_cur, limits,
                         buffers.hypotheses);
  match_.result.times.search_s += watch.lap_s();
}

/** Refines the hypotheses in descending order of their scores until a pose is convincing.
 *  @param maxStarts hypotheses that are refined at most */
void CandidateSearch::refineBest(int maxStarts)
{
  /** A hypothesis is not refined if its score is a smaller share of the best one. Unit: share.
   * Evidence: none of its own; it was chosen with the scheme as a whole. */
  constexpr double kHopeless = 0.75;
  Stopwatch watch;
  std::vector<Hypothesis>& starts = match_.buffers.hypotheses;
  for (Hypothesis& h : starts) h.score = hypothesisScore_.of(h.T_ref_cur);
  std::sort(starts.begin(), starts.end(),
            [](const Hypothesis& a, const Hypothesis& b) { return a.score > b.score; });
  match_.result.times.search_s += watch.lap_s();
  const std::size_t last = std::min(starts.size(), static_cast<std::size_t>(maxStarts));
  for (std::size_t i = 0; i < last && !verifier_.isConvincing(best_); ++i)
  {
    if (starts[i].score < kHopeless * best_.score) break;
    refineAndKeep(starts[i].T_ref_cur);
  }
}

/** Refines the best places along the direction in which the position is known worst, then along the
 * walls if these run otherwise.
 *
 * Along a wall with little else to see, lines leave the position open, and wrong pairs may hold a
 * pose anywhere. Single rays then know better, so that places are scored by rays. A guess with a
 * covariance tells the place along the wall itself, and is not searched along. */
void CandidateSearch::searchAlongWeakDirections()
{
  /** Cosine of the angle within which two directions are the same. Unit: cosine. Evidence: none of
   * its own; it was chosen with the scheme as a whole. */
  constexpr double kSame = 0.985;
  const Eigen::Vector2d weakest = best_.observability.weakDirection;
  searchAlong(weakest);
  const Eigen::Vector2d walls = directionOfWalls(match_.buffers.reference.scan->segments);
  if (std::abs(walls.dot(weakest)) < kSame) searchAlong(walls);
}

void CandidateSearch::searchAlong(const Eigen::Vector2d& direction)
{
  if (verifier_.isConvincing(best_)) return;
  proposeAlong(direction, verifier_.mayBeFarOff(best_) ? farAlong() : nearAlong());
  for (const Hypothesis& place : match_.buffers.hypotheses)
  {
    if (verifier_.isConvincing(best_)) return;
    refineAndKeep(place.T_ref_cur);
  }
}

void CandidateSearch::probeAlternatives()
{
  /** How far aside of a pose its alternatives start. Evidence: none of its own; it was chosen with
   * the scheme as a whole. */
  constexpr double kAside_m = 0.2;
  const Pose2 held = best_.T_ref_cur;
  const Eigen::Vector2d direction = best_.observability.weakDirection;
  proposeAlong(direction, nearAlong());
  refineAndKeep(moved(held, kAside_m * direction));
  refineAndKeep(moved(held, -kAside_m * direction));
  for (const Hypothesis& place : match_.buffers.hypotheses) refineAndKeep(place.T_ref_cur);
}

void CandidateSearch::proposeAlong(const Eigen::Vector2d& direction, const AlongLimits& limits)
{
  Stopwatch watch;
  findPlacesAlong(hypothesisScore_, best_.T_ref_cur, direction, limits, match_.buffers.hypotheses);
  match_.result.times.search_s += watch.lap_s();
}

AlongLimits CandidateSearch::nearAlong() const
{
  /** Most places along a wall near the pose that are refined. Unit: places. Evidence: none of its
   * own; it was chosen with the scheme as a whole. */
  constexpr std::size_t kMost = 2;

  /** How much less than the best such a place may score. Unit: score. Evidence: none of its own; it
   * was chosen with the scheme as a whole. */
  constexpr double kMissedPromise = 0.05;
  return {match_.options.searchRadius_m, 0, kMost, kMissedPromise};
}

/** Far from the guess, the score of a start says less about its refined pose: more of them are
 * refined. */
AlongLimits CandidateSearch::farAlong() const
{
  /** Most places far along a wall that are refined. Unit: places. Evidence: none of its own; it was
   * chosen with the scheme as a whole. */
  constexpr std::size_t kMost = 8;

  /** How much less than the best such a place may score. Unit: score. Evidence: none of its own; it
   * was chosen with the scheme as a whole. */
  constexpr double kMissedPromise = 0.15;

  /** Turn of the headings beside that are tried there. Evidence: none of its own; it was chosen
   * with the scheme as a whole. */
  constexpr double kTurn_rad = degToRad(1);
  const double reach_m = std::max(match_.options.searchRadius_m, match_.options.wideRadius_m);
  return {reach_m, kTurn_rad, kMost, kMissedPromise};
}
}  // namespace psmks
