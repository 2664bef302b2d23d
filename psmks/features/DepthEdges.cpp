/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/features/DepthEdges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace psmks
{
namespace
{
/** How much farther than the end of an object the scanner has to see past it. Evidence: measured.
 */
constexpr double kSeenPast_m = 0.15;

/** How much farther it has to see in a noisy scan, where that is more, so that noise makes no ends.
 * Unit: standard deviations of a range. Evidence: measured. */
constexpr double kSeenPastSigmas = 4;

/** How much farther it has to see, in addition, where neighbouring ranges on the object differ:
 * those of rays that graze a wall grow from ray to ray. Unit: differences of the outermost two
 * ranges. Evidence: measured. */
constexpr double kOwnSteps = 3;

/** Standard deviation of how far apart two scanners at different places see the end of a rounded or
 * uneven object. Evidence: measured. */
constexpr double kOtherSide_m = 0.01;

/** Probability above which rays without a return in a row may be faults. Unit: probability.
 * Definition: one edge in a hundred may be none, a small share beside those of things that moved.
 */
constexpr double kFault = 0.01;

/** Share of lost rays of a scan that shows no neighbours on a surface. Unit: share of the rays.
 * Definition: nearly all, so that no run of fewer than 459 rays without a return is an edge. */
constexpr double kMostLost = 0.99;

/** Finds the depth edges of a scan. */
class EdgeFinder
{
 public:
  EdgeFinder(const SegmentedScan& scan, std::vector<DepthEdge>& edges) : scan_(scan), edges_(edges)
  {
  }

  void run()
  {
    countLostRays();
    const double* range_m = scan_.range_m.data();
    for (int ray = 0; ray + 1 < scan_.rays(); ++ray)
      if (std::abs(range_m[ray] - range_m[ray + 1]) > kSeenPast_m) addBetween(ray, ray + 1);
    if (scan_.grid.closed() && scan_.rays() > 0) addBetween(scan_.rays() - 1, 0);
  }

 private:
  double range_m(int ray) const { return scan_.range_m[static_cast<std::size_t>(ray)]; }

  bool isSeen(int ray) const { return ray >= 0 && scan_.isValid(ray); }

  /** By how much the scanner has to see farther past an object that a ray meets. */
  double jumpAt_m(int ray) const
  {
    return std::max(kSeenPast_m, kSeenPastSigmas * std::sqrt(scan_.rangeVarianceOf_m2(ray)));
  }

  /** Counts the single rays without a return between two neighbours on one surface, and the
   * neighbours on one surface. Where a share p of the rays is lost, of n rays on surfaces n p (1 -
   * p)^2 are the former and n (1 - p)^2 the latter. */
  void countLostRays()
  {
    const double* range_m = scan_.range_m.data();
    const std::uint8_t* valid = scan_.valid.data();
    int lost = 0, pairs = 0;
    for (int ray = 0; ray + 2 < scan_.rays(); ++ray)
    {
      pairs += valid[ray] & valid[ray + 1] &
               static_cast<int>(std::abs(range_m[ray] - range_m[ray + 1]) <= kSeenPast_m);
      lost += valid[ray] & (1 - valid[ray + 1]) & valid[ray + 2] &
              static_cast<int>(std::abs(range_m[ray] - range_m[ray + 2]) <= kSeenPast_m);
    }
    lostShare_ = lost < pairs ? static_cast<double>(lost) / pairs : kMostLost;
    double probability = lostShare_;  // of as many faults in a row
    while (probability > kFault)
    {
      probability *= lostShare_;
      ++shortestVoid_;
    }
  }

  /** Adds the edges between two rays side by side. */
  void addBetween(int ray, int next)
  {
    if (isSeen(ray) && endsAt(ray, 1)) add(ray, 1);
    if (isSeen(next) && endsAt(next, -1)) add(next, -1);
  }

  /** Whether an object ends at a ray: its neighbour on the other side is on the object, and past
   * this side the scanner sees farther or nothing. */
  bool endsAt(int ray, int step) const
  {
    const int inner = scan_.grid.neighbour(ray, -step);
    if (!isSeen(inner)) return false;
    const double objectStep_m = std::abs(range_m(ray) - range_m(inner)), jump_m = jumpAt_m(ray);
    if (objectStep_m > jump_m) return false;
    const double past_m = range_m(ray) + jump_m + kOwnSteps * objectStep_m;
    for (int i = 1;; ++i)
    {
      const int outer = scan_.grid.neighbour(ray, i * step);
      if (outer < 0) return false;
      if (scan_.isValid(outer)) return range_m(outer) > past_m && isPassed(outer, step, past_m);
      if (i >= shortestVoid_) return past_m < scan_.maxRange_m;
    }
  }

  /** Whether the ray after the one that passes the object does not meet it again. */
  bool isPassed(int outer, int step, double past_m) const
  {
    const int next = scan_.grid.neighbour(outer, step);
    return !isSeen(next) || range_m(next) > past_m;
  }

  /** The object goes on past its outermost ray by half of the distance between rays on average. */
  void add(int ray, int step)
  {
    const double spacing_rad = scan_.grid.increment_rad();
    const double bearing_rad = scan_.grid.bearing_rad(ray) + step * spacing_rad / 2;
    const Eigen::Vector2d sight(std::cos(bearing_rad), std::sin(bearing_rad));
    const double slope_m = range_m(ray) - range_m(scan_.grid.neighbour(ray, -step));
    const double kept = 1 - lostShare_;
    const double variance = 1.0 / 12 + lostShare_ / (kept * kept);
    const double across_m = range_m(ray) * spacing_rad;
    edges_.push_back({(range_m(ray) + slope_m / 2) * sight, sight,
                      across_m * across_m * variance + kOtherSide_m * kOtherSide_m / 2,
                      slope_m * slope_m * variance + kOtherSide_m * kOtherSide_m / 2, step});
  }

  const SegmentedScan& scan_;
  std::vector<DepthEdge>& edges_;
  double lostShare_ = 0;  //!< of the rays on surfaces
  int shortestVoid_ = 1;  //!< fewest rays without a return in a row that are no fault
};
}  // namespace

void findDepthEdges(const SegmentedScan& scan, std::vector<DepthEdge>& edges)
{
  edges.clear();
  EdgeFinder(scan, edges).run();
}
}  // namespace psmks
