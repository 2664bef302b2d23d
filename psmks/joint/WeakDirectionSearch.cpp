/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/joint/WeakDirectionSearch.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
/** Spacing of the places along a direction. Evidence: none of its own; it was chosen with the
 * scheme as a whole. */
constexpr double kStep_m = 0.1;

int stepsWithin(double reach_m) { return static_cast<int>(reach_m / kStep_m); }

/** The score of a place, or of the heading beside its own where that scores clearly higher. */
Hypothesis bestHeading(const HypothesisScore& hypothesisScore, const Pose2& T_ref_cur,
                       double turn_rad)
{
  /** What a turned heading has to score more. Unit: score. Evidence: none of its own; it was chosen
   * with the scheme as a whole. */
  constexpr double kClearlyMore = 0.01;
  Hypothesis best{T_ref_cur, 0, hypothesisScore.of(T_ref_cur)};
  for (const double by_rad : {-turn_rad, turn_rad})
  {
    Pose2 turned = T_ref_cur;
    turned.phi_rad = wrapAngle(T_ref_cur.phi_rad + by_rad);
    const double score = hypothesisScore.of(turned);
    if (score > best.score + kClearlyMore) best = {turned, 0, score};
  }
  return best;
}

/** Of the scores in a row of places about a pose keeps the highest maxima, highest first, but for
 * the pose itself and its two neighbours. */
void keepPeaks(const AlongLimits& limits, std::vector<Hypothesis>& row)
{
  double best = 0;
  for (const Hypothesis& place : row) best = std::max(best, place.score);
  const auto notAbove = [&](std::size_t i, double score)
  { return i >= row.size() || row[i].score <= score; };
  const std::size_t middle = row.size() / 2;
  std::size_t peaks = 0;
  for (std::size_t i = 0; i < row.size(); ++i)
  {
    const double own = row[i].score;
    const bool isPeak = notAbove(i - 1, own) && notAbove(i + 1, own);
    const bool isKnown = i + 1 >= middle && i <= middle + 1;
    if (isPeak && !isKnown && own > best - limits.missedPromise) row[peaks++] = row[i];
  }
  row.resize(peaks);
  std::sort(row.begin(), row.end(),
            [](const Hypothesis& a, const Hypothesis& b) { return a.score > b.score; });
  row.resize(std::min(peaks, limits.most));
}
}  // namespace

void findPlacesAlong(const HypothesisScore& hypothesisScore, const Pose2& T_ref_cur,
                     const Eigen::Vector2d& direction, const AlongLimits& limits,
                     std::vector<Hypothesis>& places)
{
  /** Distance from which on turned headings are tried, because the walls there may be others.
   * Evidence: none of its own; it was chosen with the scheme as a whole. */
  constexpr double kFar_m = 0.8;
  const int reach = stepsWithin(limits.reach_m);
  places.clear();
  for (int k = -reach; k <= reach; ++k)
  {
    const double along_m = kStep_m * k;
    const Pose2 place{T_ref_cur.x_m + along_m * direction.x(),
                      T_ref_cur.y_m + along_m * direction.y(), T_ref_cur.phi_rad};
    const bool isTurned = limits.turn_rad > 0 && std::abs(along_m) > kFar_m;
    places.push_back(isTurned ? bestHeading(hypothesisScore, place, limits.turn_rad)
                              : Hypothesis{place, 0, hypothesisScore.of(place)});
  }
  keepPeaks(limits, places);
}

std::size_t mostPlacesAlong(double reach_m)
{
  return 2 * static_cast<std::size_t>(stepsWithin(reach_m)) + 1;
}

Eigen::Vector2d directionOfWalls(const std::vector<Segment>& segments)
{
  // A wall has no front end: directions are averaged at twice their angle.
  double sumX = 0, sumY = 0;
  for (const Segment& segment : segments)
  {
    const Eigen::Vector2d along_m = segment.lastEnd_m - segment.firstEnd_m;
    const double length_m = along_m.norm();
    if (!(length_m > 0)) continue;
    sumX += (along_m.x() * along_m.x() - along_m.y() * along_m.y()) / length_m;
    sumY += 2 * along_m.x() * along_m.y() / length_m;
  }
  const double angle_rad = 0.5 * std::atan2(sumY, sumX);
  return {std::cos(angle_rad), std::sin(angle_rad)};
}
}  // namespace psmks
