/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/features/CirclePairing.h>
#include <psmks/features/EdgePairing.h>
#include <psmks/joint/LinePairing.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
/** Covariance of (distance, angle) of a current line at its anchor against a reference line. */
Eigen::Matrix2d pairCovariance(const AnchoredLine& ref, const AnchoredLine& cur, double along_m)
{
  // The reference line swings about its own anchor: its distance at `along` from there is off by
  // along d(phi), and the residual's angle by -d(phi).
  Eigen::Matrix2d C;
  C(0, 0) = cur.distanceVariance_m2 + ref.distanceVariance_m2 +
            along_m * along_m * ref.angleVariance_rad2;
  C(0, 1) = C(1, 0) = -along_m * ref.angleVariance_rad2;
  C(1, 1) = cur.angleVariance_rad2 + ref.angleVariance_rad2;
  return C;
}

/** The stretch of rays of the reference grid that both segments cover. */
struct SharedRays
{
  double first, last;  //!< fractional indices, last >= first; beyond count on a closed grid
  double count() const { return last - first + 1; }
};

class Pairing
{
 public:
  Pairing(const ScanFeatures& reference, const ScanFeatures& current, const Pose2& T_ref_cur,
          const PairingGates& gates, JointProblem& problem)
      : ref_(reference),
        cur_(current),
        T_ref_cur_(T_ref_cur),
        R_(T_ref_cur.rotation()),
        gates_(gates),
        largestSine_(std::sin(gates.angle_rad)),
        problem_(problem)
  {
  }

  int run()
  {
    for (std::size_t c = 0; c < lineFeatures(cur_); ++c)
      if (!isRound(cur_, cur_.lineFeatures[c])) pairLineFeature(c);
    if (gates_.pairShortLinesAndCircles)
    {
      circles_ = pairCircles(ref_.circles, cur_.circles, T_ref_cur_, gates_.distance_m,
                             problem_.circlePairs);
      associations_ += circles_.rays;
    }
    associations_ +=
        pairEdges(ref_.edges, cur_.edges, T_ref_cur_, gates_.edgeDistance_m, problem_.rays);
    pairUnsegmentedRays(cur_, ref_, T_ref_cur_, true);
    pairUnsegmentedRays(ref_, cur_, T_ref_cur_.inverse(), false);
    return associations_;
  }

 private:
  /** How many of a scan's straight lines are to be paired. */
  std::size_t lineFeatures(const ScanFeatures& features) const
  {
    return gates_.pairShortLinesAndCircles ? features.lineFeatures.size()
                                           : features.scan->segments.size();
  }

  /** Whether a segment has turned out to be part of an arc and is left to the circles. */
  bool isRound(const ScanFeatures& features, const Segment& straight) const
  {
    return gates_.pairShortLinesAndCircles &&
           features.circleOfRay[static_cast<std::size_t>(straight.firstRay)] >= 0;
  }

  double index(const Eigen::Vector2d& p_ref_m) const
  {
    return ref_.scan->grid.index(
        fastBearing_rad(static_cast<float>(p_ref_m.y()), static_cast<float>(p_ref_m.x())));
  }

  void pairLineFeature(std::size_t c)
  {
    const Segment& segment = cur_.lineFeatures[c];
    const Eigen::Vector2d first_m = T_ref_cur_ * segment.firstEnd_m;
    const Eigen::Vector2d last_m = T_ref_cur_ * segment.lastEnd_m;
    const Eigen::Vector2d normal = R_ * cur_.lines[c].normal;
    if (!(normal.dot(first_m) > 0)) return;  // seen from behind
    const double first = index(first_m);
    double last = index(last_m);
    const double circle = ref_.scan->rays();
    if (last < first) last += ref_.scan->grid.closed() ? circle : 0;
    if (!(last > first)) return;

    for (std::size_t r = 0; r < lineFeatures(ref_); ++r)
    {
      const Segment& other = ref_.lineFeatures[r];
      if (isRound(ref_, other)) continue;
      const double refFirst = other.firstRay;
      const double refLast = other.lastRay + (other.lastRay < other.firstRay ? circle : 0);
      tryPair(c, r, {std::max(first, refFirst), std::min(last, refLast)}, normal, first_m);
      if (!ref_.scan->grid.closed()) continue;
      tryPair(c, r, {std::max(first, refFirst + circle), std::min(last, refLast + circle)}, normal,
              first_m);
      tryPair(c, r, {std::max(first + circle, refFirst), std::min(last + circle, refLast)}, normal,
              first_m);
    }
  }

  /** Both lines where the shared stretch begins and ends: they must stand within the distance gate.
   */
  void tryPair(std::size_t c, std::size_t r, const SharedRays& shared,
               const Eigen::Vector2d& normal, const Eigen::Vector2d& pointOnCurrent_m)
  {
    /** Fewest rays that two lines have to share. Unit: rays. Evidence: measured. */
    constexpr double kFewestShared = 2;
    if (!(shared.count() >= kFewestShared)) return;
    const AnchoredLine& ref = ref_.lines[r];
    const double sine = ref.normal.x() * normal.y() - ref.normal.y() * normal.x();
    if (ref.normal.dot(normal) <= 0 || std::abs(sine) > largestSine_) return;
    const double curDistance_m = normal.dot(pointOnCurrent_m);
    const double refDistance_m = ref_.lineFeatures[r].line.r0_m;
    for (const double at : {shared.first, shared.last})
    {
      const int ray = static_cast<int>(std::lround(at)) % ref_.scan->rays();
      const Eigen::Vector2d direction = ref_.scan->grid.direction(ray);
      const double curCosine = normal.dot(direction);
      if (!(curCosine > 0)) return;
      const double offset_m = ref.normal.dot(direction) * curDistance_m / curCosine - refDistance_m;
      if (std::abs(offset_m) > gates_.distance_m) return;
    }
    addPair(c, r);
    associations_ += static_cast<int>(shared.count());
  }

  void addPair(std::size_t c, std::size_t r)
  {
    const AnchoredLine& ref = ref_.lines[r];
    const AnchoredLine& cur = cur_.lines[c];
    const Eigen::Vector2d anchor_ref_m = T_ref_cur_ * cur.anchor_m;
    const double along_m = ref.along.dot(anchor_ref_m - ref.anchor_m);
    const double angle_rad =
        cur_.lineFeatures[c].line.phi0_rad - ref_.lineFeatures[r].line.phi0_rad;
    const Eigen::Matrix2d covariance = pairCovariance(ref, cur, along_m);
    problem_.linePairs.push_back({ref.normal, ref.normal.dot(ref.anchor_m), cur.anchor_m,
                                  wrapAngle(angle_rad), covariance.inverse(), covariance(1, 1)});
  }

  /** Single rays of one scan against the lines of the other. */
  void pairUnsegmentedRays(const ScanFeatures& from, const ScanFeatures& to, const Pose2& T_to_from,
                           bool current)
  {
    const Eigen::Matrix2d R = T_to_from.rotation();
    const Eigen::Vector2d t = T_to_from.translation();
    for (const int single : from.unsegmentedRays)
    {
      if (isOnShortLineOrPairedCircle(from, current ? circles_.current : circles_.reference,
                                      single))
        continue;
      const Eigen::Vector2d point_m = from.scan->point_m(single);
      const Eigen::Vector2d p_m = R * point_m + t;
      const int line = nearestLine(to, p_m);
      if (line < 0) continue;
      const AnchoredLine& l = to.lines[static_cast<std::size_t>(line)];
      // The error of a range moves the point along its ray; only the part across the line counts.
      const double cosine = l.normal.dot(R * from.scan->grid.direction(single));
      const double variance_m2 = from.scan->rangeVarianceOf_m2(single) * cosine * cosine +
                                 l.distanceVarianceAt_m2(p_m) +
                                 gates_.unsegmentedRaySlack_m * gates_.unsegmentedRaySlack_m;
      problem_.rays.push_back({current, point_m, l.normal, l.normal.dot(l.anchor_m),
                               gates_.singleRayWeight / (from.scan->raysPerReading * variance_m2)});
      ++associations_;
    }
  }

  /** Whether an unsegmented ray is no single ray: it lies on a short line, paired or not, or on a
   * circle that was paired. */
  bool isOnShortLineOrPairedCircle(const ScanFeatures& features,
                                   const std::bitset<kMostCircles>& paired, int ray) const
  {
    if (!gates_.pairShortLinesAndCircles) return false;
    const int circle = features.circleOfRay[static_cast<std::size_t>(ray)];
    return isOnLineFeature(features, ray) ||
           (circle >= 0 && paired[static_cast<std::size_t>(circle)]);
  }

  static bool isOnLineFeature(const ScanFeatures& features, int ray)
  {
    const int line = features.lineOfRay[static_cast<std::size_t>(ray)];
    return line >= 0 && line < static_cast<int>(features.lineFeatures.size());
  }

  /** Of the lines at the bearing of a point the nearer one within the gate, or -1. */
  int nearestLine(const ScanFeatures& features, const Eigen::Vector2d& p_m) const
  {
    const auto x = static_cast<float>(p_m.x()), y = static_cast<float>(p_m.y());
    const int k = features.surface.cellOf(x, y);
    if (k < 0) return -1;
    const PolarLookup::Side* sides = features.surface.sides(k);
    int nearest = -1;
    auto best_m = static_cast<float>(gates_.distance_m);
    for (int side = 0; side < 2; ++side)
    {
      const float d_m = std::fabs(sides[side].distance_m(x, y));
      if (sides[side].line < 0 || d_m >= best_m) continue;
      best_m = d_m;
      nearest = sides[side].line;
    }
    return nearest;
  }

  const ScanFeatures& ref_;
  const ScanFeatures& cur_;
  const Pose2& T_ref_cur_;
  const Eigen::Matrix2d R_;
  const PairingGates& gates_;
  const double largestSine_;
  JointProblem& problem_;
  PairedCircles circles_;
  int associations_ = 0;
};
}  // namespace

int associateFeatures(const ScanFeatures& reference, const ScanFeatures& current,
                      const Pose2& T_ref_cur, const PairingGates& gates, JointProblem& problem)
{
  return Pairing(reference, current, T_ref_cur, gates, problem).run();
}
}  // namespace psmks
