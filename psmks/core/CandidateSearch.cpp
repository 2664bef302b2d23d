/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/core/CandidateSearch.h>
#include <psmks/core/Stopwatch.h>

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

/** Of scores in a row the highest maxima, highest first, among those with a vote. */
void keepPeaks(std::vector<Hypothesis>& row)
{
  constexpr std::size_t kMost = 2;
  constexpr double kAsGood = 0.05;
  double best = 0;
  for (const Hypothesis& place : row) best = std::max(best, place.score);
  const auto notAbove = [&](std::size_t i, double score)
  { return i >= row.size() || row[i].score <= score; };
  std::size_t peaks = 0;
  for (std::size_t i = 0; i < row.size(); ++i)
  {
    const double own = row[i].score;
    if (!notAbove(i - 1, own) || !notAbove(i + 1, own) || own <= best - kAsGood) row[i].votes = 0;
    peaks += row[i].votes > 0;
  }
  std::sort(row.begin(), row.end(),
            [](const Hypothesis& a, const Hypothesis& b)
            { return a.votes != b.votes ? a.votes > b.votes : a.score > b.score; });
  row.resize(std::min(peaks, kMost));
}
}  // namespace

/** A start that explained more before was drawn to lines that are not its own - the other face of a
 * thin wall: once more with narrower gates. */
void CandidateSearch::consider(const Pose2& start)
{
  constexpr double kNarrow = 0.5;
  ++match_.result.hypotheses;
  const RefinedPose candidate = refinement_.refine(start);
  keepIfBest(candidate);
  if (candidate.dissent_rad != 0) keepIfBest(refinement_.refine(heard(candidate), kNarrow));
  const bool canNarrow = match_.options.reassociations > 1 && candidate.score > 0;
  if (!canNarrow || judge_.isConvincing(candidate)) return;
  if (freeSpaceScore(match_.scores.allCounts(start)) > candidate.score)
    keepIfBest(refinement_.refine(start, kNarrow));
}

/** The pose turned to where the pair of lines that knows the heading best wants it. */
Pose2 CandidateSearch::heard(const RefinedPose& candidate)
{
  Pose2 T = candidate.T_ref_cur;
  T.phi_rad = wrapAngle(T.phi_rad - candidate.dissent_rad);
  return T;
}

void CandidateSearch::keepIfBest(const RefinedPose& candidate)
{
  mostAssociations_ = std::max(mostAssociations_, candidate.associations);
  if (candidate.associations < match_.options.minAssociations) return;
  if (match_.trace)
    match_.trace->steps.push_back(
        {"gauss-newton", candidate.T_ref_cur, candidate.score, candidate.associations, 0});
  match_.buffers.considered.push_back(candidate);
  if (best_.score > 0 && judge_.merit(candidate) <= judge_.merit(best_)) return;
  best_ = candidate;
}

void CandidateSearch::searchFurther()
{
  const JointOptions& options = match_.options;
  match_.buffers.hypotheses.clear();
  propose({options.searchRadius_m, options.searchAngle_rad, options.votedAngles});
  if (match_.result.hypotheses == 0)
    match_.buffers.hypotheses.push_back({match_.guess.T_ref_cur, 0, 0});
  considerMostPromising(options.refinedHypotheses);
  constexpr double kEnough = 0.25;  // of the rays in common for single ones to tell a place
  if (!match_.guessPrior && !judge_.isConvincing(best_) && match_.pairsMoreThan(kEnough, best_))
    slide();
}

void CandidateSearch::searchWide()
{
  constexpr int kTimes = 3;            // as many angles and starts as near the guess
  constexpr double kMoreFarOff = 0.1;  // of the rays than an acceptable pose near the guess
  const RefinedPose nearGuess = best_;
  const JointOptions& options = match_.options;
  JointBuffers& buffers = match_.buffers;
  buffers.hypotheses.clear();
  propose({options.wideRadius_m, options.wideAngle_rad, kTimes * options.votedAngles});
  Stopwatch watch;
  buffers.wideSearch.propose(match_.scores, match_.guess.T_ref_cur, options.wideRadius_m,
                             options.wideAngle_rad, buffers.hypotheses);
  match_.result.times.search_s += watch.lap_s();
  considerMostPromising(kTimes * options.refinedHypotheses);
  if (judge_.isAcceptable(nearGuess) && best_.score < nearGuess.score + kMoreFarOff)
    best_ = nearGuess;
}

/** What segment angles and line intersections vote for. */
void CandidateSearch::propose(const SearchLimits& limits)
{
  Stopwatch watch;
  JointBuffers& buffers = match_.buffers;
  buffers.search.propose(buffers.reference, buffers.current, match_.guess.T_ref_cur, limits,
                         buffers.hypotheses);
  match_.result.times.search_s += watch.lap_s();
}

/** Of the hypotheses, until a pose is convincing. */
void CandidateSearch::considerMostPromising(int most)
{
  constexpr double kHopeless = 0.75;  // promise, as a share of the best score, not worth a look
  Stopwatch watch;
  std::vector<Hypothesis>& starts = match_.buffers.hypotheses;
  for (Hypothesis& h : starts) h.score = promise(h.T_ref_cur);
  std::sort(starts.begin(), starts.end(),
            [](const Hypothesis& a, const Hypothesis& b) { return a.score > b.score; });
  match_.result.times.search_s += watch.lap_s();
  const std::size_t last = std::min(starts.size(), static_cast<std::size_t>(most));
  for (std::size_t i = 0; i < last && !judge_.isConvincing(best_); ++i)
  {
    if (starts[i].score < kHopeless * best_.score) break;
    consider(starts[i].T_ref_cur);
  }
}

/** The rough score of a start, less where it is remote: of starts that explain the scans alike - a
 * square room looks the same four ways - the one nearer the guess goes first. At the limits of the
 * search the score counts this much less. */
double CandidateSearch::promise(const Pose2& T_ref_cur) const
{
  constexpr double kAtLimits = 0.05;
  const Pose2 T_guess_start = match_.guess.T_ref_cur.inverse() * T_ref_cur;
  const double remoteness = kAtLimits *
                            (std::abs(T_guess_start.phi_rad) / match_.options.searchAngle_rad +
                             T_guess_start.translation().norm() / match_.options.searchRadius_m) /
                            2;
  return match_.scores.roughScore(T_ref_cur) - remoteness;
}

/** Along a wall with little else to see, lines leave open where a pose is, and wrong pairs may
 * hold it anywhere. Single rays then know better: the places along the direction that is known
 * worst are scored, and those that explain more than the best pose so far, or about as much, are
 * refined. Where the guess was measured, it tells the place along the wall; and scans that have
 * little in common may fit anywhere by chance. */
void CandidateSearch::slide()
{
  findPlacesAlong();
  for (const Hypothesis& place : match_.buffers.hypotheses)
  {
    if (judge_.isConvincing(best_)) return;
    consider(place.T_ref_cur);
  }
}

void CandidateSearch::challenge()
{
  constexpr double kAside_m = 0.2;
  const Pose2 held = best_.T_ref_cur;
  const Eigen::Vector2d aside_m = kAside_m * best_.observability.weakDirection;
  findPlacesAlong();
  consider(moved(held, aside_m));
  consider(moved(held, -aside_m));
  for (const Hypothesis& place : match_.buffers.hypotheses) consider(place.T_ref_cur);
}

/** Leaves in the hypotheses the most promising places along the direction in which the best pose is
 * known worst, but for that pose itself. */
void CandidateSearch::findPlacesAlong()
{
  constexpr double kStep_m = 0.1;
  Stopwatch watch;
  const Eigen::Vector2d step_m = kStep_m * best_.observability.weakDirection;
  const int reach = static_cast<int>(match_.options.searchRadius_m / kStep_m);
  std::vector<Hypothesis>& places = match_.buffers.hypotheses;
  places.clear();
  for (int k = -reach; k <= reach; ++k)
  {
    const Pose2 T = moved(best_.T_ref_cur, k * step_m);
    const bool isKnown = std::abs(k) <= 1;
    places.push_back({T, isKnown ? 0.0 : 1.0, promise(T)});
  }
  keepPeaks(places);
  match_.result.times.search_s += watch.lap_s();
}
}  // namespace psmks
