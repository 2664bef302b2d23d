/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/base/Stopwatch.h>
#include <psmks/joint/CandidateSearch.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
void CandidateSearch::reserve()
{
  match_.buffers.correlativeSearch.reserve();
  match_.buffers.hypotheses.reserve(farStarts());
}

void CandidateSearch::refineAndKeep(const Pose2& start)
{
  /** Width of the first gates of a second refinement. Unit: share of the gates. Evidence: measured.
   */
  constexpr double kNarrow = 0.5;
  ++match_.result.hypotheses;
  const RefinedPose candidate = refinement_.refine(start);
  keepIfBest(candidate);
  if (verifier_.isConvincing(candidate) || !(candidate.score > 0)) return;
  if (freeSpaceScore(match_.scores.allCounts(start)) > candidate.score)
    keepIfBest(refinement_.refine(start, kNarrow));
}

void CandidateSearch::keepIfBest(const RefinedPose& candidate)
{
  mostAssociations_ = std::max(mostAssociations_, candidate.associations);
  if (candidate.associations < match_.options.minAssociations) return;
  if (match_.trace)
    match_.trace->steps.push_back({"refinement", candidate.T_ref_cur, std::nullopt, candidate.score,
                                   candidate.associations, 0});
  match_.buffers.refinedPoses.push_back(candidate);
  if (best_.score >= 0 && candidate.logPosterior <= best_.logPosterior) return;
  best_ = candidate;
}

void CandidateSearch::followVotes()
{
  /** A pose that lines vote for is not refined if its rough score is a smaller share of the best
   * score so far. Unit: share. Evidence: measured. */
  constexpr double kHopeless = 0.5;
  Stopwatch watch;
  const JointOptions& options = match_.options;
  JointBuffers& buffers = match_.buffers;
  std::vector<Hypothesis>& voted = buffers.hypotheses;
  voted.clear();
  buffers.lineVotes.propose(buffers.reference, buffers.current, match_.guess.T_ref_cur,
                            {options.searchRadius_m, options.searchAngle_rad, options.votedAngles},
                            voted);
  for (Hypothesis& pose : voted) pose.score = match_.scores.roughScore(pose.T_ref_cur);
  std::sort(voted.begin(), voted.end(),
            [](const Hypothesis& a, const Hypothesis& b) { return a.score > b.score; });
  match_.result.times.search_s += watch.lap_s();
  const std::size_t most = std::min(voted.size(), nearStarts());
  for (std::size_t i = 0; i < most && !verifier_.isConvincing(best_); ++i)
    if (voted[i].score >= kHopeless * best_.score) refineAndKeep(voted[i].T_ref_cur);
}

void CandidateSearch::searchNear() { search(nearWindow(), nearStarts()); }

void CandidateSearch::searchWide()
{
  if (!match_.prior())
    search(wideWindow(), farStarts());
  else if (!verifier_.isAcceptable(best_))
    searchDespiteGuess();
}

/** Where wheels have slipped, the guess is no measurement of the motion: it is given up for a pose
 * that is beyond doubt without it. What was refined under one prior is not compared with what was
 * refined under the other. */
void CandidateSearch::searchDespiteGuess()
{
  const RefinedPose nearGuess = best_;
  const int mostNearGuess = mostAssociations_;
  std::vector<RefinedPose>& refined = match_.buffers.refinedPoses;
  const auto nearPoses = static_cast<std::ptrdiff_t>(refined.size());
  best_ = {};
  match_.result.guessGivenUp = true;
  search(wideWindow(), farStarts());
  match_.result.guessGivenUp = verifier_.isBeyondDoubt(best_);
  if (match_.result.guessGivenUp)
  {
    refined.erase(refined.begin(), refined.begin() + nearPoses);
    return;
  }
  refined.erase(refined.begin() + nearPoses, refined.end());
  best_ = nearGuess;
  mostAssociations_ = mostNearGuess;
}

void CandidateSearch::search(const SearchWindow& window, std::size_t mostStarts)
{
  proposeOptima(window, mostStarts);
  for (const Hypothesis& optimum : match_.buffers.hypotheses)
    if (!verifier_.isConvincing(best_)) refineAndKeep(optimum.T_ref_cur);
}

/** Fills the buffer of hypotheses with the optima of CorrelativeSearch. */
void CandidateSearch::proposeOptima(const SearchWindow& window, std::size_t mostStarts)
{
  Stopwatch watch;
  JointBuffers& buffers = match_.buffers;
  buffers.correlativeSearch.propose(buffers.reference, buffers.current, match_.guess.T_ref_cur,
                                    window, match_.scores.tolerance_m(), mostStarts,
                                    buffers.hypotheses);
  match_.result.times.search_s += watch.lap_s();
}

void CandidateSearch::searchWithinCovariance()
{
  refineAndKeep(match_.guess.T_ref_cur);
  proposeOptima(match_.guess.covariance ? windowOfCovariance() : nearWindow(), farStarts());
  for (const Hypothesis& optimum : match_.buffers.hypotheses) refineAndKeep(optimum.T_ref_cur);
}

/** The window that a measured guess leaves open; no heading is more than half a turn away. */
SearchWindow CandidateSearch::windowOfCovariance() const
{
  /** Size of the window about a measured guess. Unit: standard deviations. Evidence: 99.7 % of
   * normal errors. */
  constexpr double kSigmas = 3;
  const Eigen::Matrix3d& C = *match_.guess.covariance;
  return {kSigmas * std::sqrt(std::max(C(0, 0), C(1, 1))),
          std::min(kPi, kSigmas * std::sqrt(C(2, 2)))};
}

SearchWindow CandidateSearch::nearWindow() const
{
  const SearchWindow widest{match_.options.searchRadius_m, match_.options.searchAngle_rad};
  if (!match_.prior()) return widest;
  const SearchWindow open = windowOfCovariance();
  return {std::min(widest.radius_m, open.radius_m), std::min(widest.angle_rad, open.angle_rad)};
}

SearchWindow CandidateSearch::wideWindow() const
{
  return {match_.options.wideRadius_m, match_.options.wideAngle_rad};
}

std::size_t CandidateSearch::nearStarts() const
{
  return static_cast<std::size_t>(match_.options.refinedHypotheses);
}

std::size_t CandidateSearch::farStarts() const
{
  /** How many times as many optima are refined in the wide window, which has more places that look
   * alike. Unit: ratio. Evidence: of every fourth scan of the MIT CSAIL log (`csail`) 90.2 % are
   * found with as many as near the guess, 91.7 % with twice as many; of every eighth 63.8 and
   * 66.7 %. */
  constexpr std::size_t kTimes = 2;
  return kTimes * nearStarts();
}
}  // namespace psmks
