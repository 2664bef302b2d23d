/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/joint/CorrelativeSearch.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
/** A grid's spacing, and how near a surface a ray of a pose between its points still comes. */
struct Fineness
{
  double step_m, step_rad, tolerance_m;
};

/** Spacing and tolerance of the grid. Unit: m, rad, m. Evidence: the tolerance is the spacing, so
 * that no surface falls between two points; other spacings were not tried. */
constexpr Fineness kGrid{0.5, degToRad(6), 0.5};

/** Spacings and tolerances of the climb from the best points of the grid. Unit: m, rad, m.
 * Evidence: each about halves the one before; others were not tried. */
constexpr Fineness kFiner[] = {{0.25, degToRad(3), 0.3}, {0.12, degToRad(1.5), 0.15}};

/** Most hypotheses of the search. Unit: hypotheses. Evidence: none of its own; it was chosen with
 * the scheme as a whole. */
constexpr std::ptrdiff_t kProposed = 12;

bool scoresMore(const Hypothesis& a, const Hypothesis& b) { return a.score > b.score; }

void keepBest(std::size_t most, std::vector<Hypothesis>& places)
{
  const auto kept = static_cast<std::ptrdiff_t>(std::min(most, places.size()));
  std::partial_sort(places.begin(), places.begin() + kept, places.end(), scoresMore);
  places.resize(static_cast<std::size_t>(kept));
}

bool isSamePlace(const Pose2& a, const Pose2& b)
{
  /** Distance and angle within which two hypotheses lead to the same place. Evidence: none of its
   * own; it was chosen with the scheme as a whole. */
  constexpr double kApart_m = 0.3, kApart_rad = degToRad(5);
  return (a.translation() - b.translation()).norm() < kApart_m &&
         std::abs(wrapAngle(a.phi_rad - b.phi_rad)) < kApart_rad;
}

/** To the best of its 26 neighbours, if that is better. */
void step(const ScanScores& scores, const Fineness& fine, Hypothesis& place)
{
  const Pose2 from = place.T_ref_cur;
  place.score = scores.scoreWithin(from, fine.tolerance_m);
  for (const int turn : {-1, 0, 1})
    for (const int x : {-1, 0, 1})
      for (const int y : {-1, 0, 1})
      {
        const Pose2 T{from.x_m + fine.step_m * x, from.y_m + fine.step_m * y,
                      wrapAngle(from.phi_rad + fine.step_rad * turn)};
        const double score = scores.scoreWithin(T, fine.tolerance_m);
        if (score > place.score) place = {T, 0, score};
      }
}
}  // namespace

void CorrelativeSearch::propose(const ScanScores& scores, const Pose2& guess_T_ref_cur,
                                const CorrelativeLimits& limits,
                                std::vector<Hypothesis>& hypotheses)
{
  scoreGrid(scores, guess_T_ref_cur, limits);
  keepBest(limits.followed, places_);
  climb(scores);
  std::sort(places_.begin(), places_.end(), scoresMore);

  hypotheses.clear();
  for (const Hypothesis& place : places_)
  {
    const auto leadsThere = [&](const Hypothesis& other)
    { return isSamePlace(place.T_ref_cur, other.T_ref_cur); };
    if (hypotheses.size() == kProposed) return;
    if (std::none_of(hypotheses.begin(), hypotheses.end(), leadsThere)) hypotheses.push_back(place);
  }
}

void CorrelativeSearch::reserve(double radius_m, double angle_rad)
{
  const auto across = static_cast<std::size_t>(2 * radius_m / kGrid.step_m) + 1;
  const auto headings = static_cast<std::size_t>(2 * angle_rad / kGrid.step_rad) + 1;
  places_.reserve(across * across * headings);
}

void CorrelativeSearch::scoreGrid(const ScanScores& scores, const Pose2& guess_T_ref_cur,
                                  const CorrelativeLimits& limits)
{
  const int moves = static_cast<int>(limits.radius_m / kGrid.step_m);
  const int turns = static_cast<int>(limits.angle_rad / kGrid.step_rad);
  places_.clear();
  for (int turn = -turns; turn <= turns; ++turn)
    for (int x = -moves; x <= moves; ++x)
      for (int y = -moves; y <= moves; ++y)
      {
        if (x * x + y * y > moves * moves) continue;
        const Pose2 T{guess_T_ref_cur.x_m + kGrid.step_m * x,
                      guess_T_ref_cur.y_m + kGrid.step_m * y,
                      wrapAngle(guess_T_ref_cur.phi_rad + kGrid.step_rad * turn)};
        places_.push_back({T, 0, scores.scoreWithin(T, kGrid.tolerance_m)});
      }
}

void CorrelativeSearch::climb(const ScanScores& scores)
{
  for (const Fineness& fine : kFiner)
    for (Hypothesis& place : places_) step(scores, fine, place);
}
}  // namespace psmks
