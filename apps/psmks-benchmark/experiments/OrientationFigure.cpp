/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/experiments/OrientationFigure.h>
#include <psmks/core/Matcher.h>
#include <psmks/paper/OrientationSearch.h>
#include <psmks/sim/Laser.h>
#include <psmks/sim/World.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace psmks
{
namespace
{
constexpr int kPairs = 200;
constexpr double kMinClearance_m = 0.5;
constexpr double kMaxRange_m = 30;
constexpr double kRange_rad = degToRad(20);
constexpr double kStep_rad = degToRad(0.2);
constexpr int kSteps = 100;  // steps of kStep_rad to either side

// Largest motion between the two scans of a pair.
constexpr double kMaxShift_m = 0.8, kMaxTurn_rad = degToRad(20);

/** The original PSM has no segments. It pairs rays whose ranges differ by less than this. */
constexpr double kOpenGate_m = 1.0;

/** Two segmented scans without noise. */
struct ExactPair
{
  SegmentedScan reference, current;
  Pose2 T_ref_cur;
};

/** An error over the heading. A point is the difference from the true heading in degrees and the
 * error. */
using Curve = std::vector<Eigen::Vector2d>;

class PairCaster
{
 public:
  explicit PairCaster(unsigned seed)
      : world_(World::smallClutter(seed)), random_(seed), matcher_(MatcherOptions::paperScheme())
  {
    laser_.maxRange_m = kMaxRange_m;
    laser_.rangeSigma_m = 0;
  }

  ExactPair next()
  {
    ExactPair pair;
    const Pose2 T_world_ref = world_.randomFreePose(kMinClearance_m, random_);
    Pose2 T_world_cur;
    do
    {
      pair.T_ref_cur = {uniform(kMaxShift_m), uniform(kMaxShift_m), uniform(kMaxTurn_rad)};
      T_world_cur = T_world_ref * pair.T_ref_cur;
    } while (!isClear(T_world_cur.translation()));
    cast(T_world_ref, pair.reference);
    cast(T_world_cur, pair.current);
    return pair;
  }

 private:
  double uniform(double max) { return std::uniform_real_distribution<double>(-max, max)(random_); }

  bool isClear(const Eigen::Vector2d& point_m) const
  {
    return world_.isFree(point_m) &&
           world_.clearance_m(point_m, kMinClearance_m, 0) >= kMinClearance_m;
  }

  void cast(const Pose2& T_world_sensor, SegmentedScan& result)
  {
    matcher_.segment(castScan(world_, T_world_sensor, laser_, random_).scan, workspace_, result);
  }

  World world_;
  std::mt19937_64 random_;
  LaserOptions laser_;
  Matcher matcher_;
  MatcherWorkspace workspace_;
};

/** The search of the paper at the true position.
 *  @param[out] curve its errors
 *  @return the error of the heading that it finds */
double searchSimilar(const ExactPair& pair, Curve& curve)
{
  PaperOptions options = MatcherOptions::paperScheme().paper;
  options.coarseRange_rad = kRange_rad;
  options.coarseStep_rad = kStep_rad;
  PoseObjective objective;
  objective.assign(pair.reference, pair.current, options);
  MatchTrace trace;
  const OrientationMinimum minimum = searchOrientation(objective, pair.T_ref_cur, &trace);

  curve.clear();
  const MatchTrace::OrientationCurve& coarse = trace.orientationCurves.front();
  for (std::size_t i = 0; i < coarse.phi_rad.size(); ++i)
    if (coarse.associations[i] >= options.minAssociations)
      curve.emplace_back(radToDeg(wrapAngle(coarse.phi_rad[i] - pair.T_ref_cur.phi_rad)),
                         coarse.error[i]);
  return std::abs(wrapAngle(minimum.phi_rad - pair.T_ref_cur.phi_rad));
}

/** The reference range at a bearing between two rays; 0 if one of them has no range. Along a line 1
 * / range is a cosine of the bearing, which is linear over so small an angle. */
double referenceRange_m(const SegmentedScan& reference, double index)
{
  const auto below = static_cast<int>(std::floor(index));
  if (below < 0 || below + 1 >= reference.rays()) return 0;
  if (!reference.isValid(below) || !reference.isValid(below + 1)) return 0;
  const auto i = static_cast<std::size_t>(below);
  const double share = index - below;
  return 1 / ((1 - share) / reference.range_m[i] + share / reference.range_m[i + 1]);
}

/** Mean errors over the rays at one heading. */
struct RayErrors
{
  double absolute_m = 0, squared_m2 = 0;
};

/** Compares each current ray with the reference ray at its bearing, whatever surfaces they met. */
RayErrors compareRays(const ExactPair& pair, const Pose2& T_ref_cur)
{
  RayErrors sum;
  int rays = 0;
  for (int ray = 0; ray < pair.current.rays(); ++ray)
  {
    if (!pair.current.isValid(ray)) continue;
    const Eigen::Vector2d p = T_ref_cur * pair.current.point_m(ray);
    const double range_m =
        referenceRange_m(pair.reference, pair.reference.grid.index(std::atan2(p.y(), p.x())));
    const double residual_m = range_m - p.norm();
    if (range_m == 0 || std::abs(residual_m) > kOpenGate_m) continue;
    sum.absolute_m += std::abs(residual_m);
    sum.squared_m2 += residual_m * residual_m;
    ++rays;
  }
  return {sum.absolute_m / rays, sum.squared_m2 / rays};
}

/** The search of the original PSM without its tests for occlusion. */
struct RaySearch
{
  Curve absolute, squared;

  explicit RaySearch(const ExactPair& pair)
  {
    for (int k = -kSteps; k <= kSteps; ++k)
    {
      Pose2 tested = pair.T_ref_cur;
      tested.phi_rad += k * kStep_rad;
      const RayErrors errors = compareRays(pair, tested);
      absolute.emplace_back(radToDeg(k * kStep_rad), errors.absolute_m);
      squared.emplace_back(radToDeg(k * kStep_rad), errors.squared_m2);
    }
  }
};

/** The distance of the minimum of a curve from the true heading. */
double miss_rad(const Curve& curve)
{
  const auto lower = [](const auto& a, const auto& b) { return a.y() < b.y(); };
  return degToRad(std::abs(std::min_element(curve.begin(), curve.end(), lower)->x()));
}

void count(OrientationExperiment::Misses& misses, double miss_rad)
{
  misses.mean_rad += miss_rad / kPairs;
  misses.max_rad = std::max(misses.max_rad, miss_rad);
}

/** A curve scaled to a maximum of 1, so that errors of different units can be compared. */
ChartSeries scaled(const std::string& name, Curve points)
{
  double largest = 0;
  for (const auto& p : points) largest = std::max(largest, p.y());
  for (auto& p : points) p.y() /= largest;
  return {name, std::move(points)};
}

Chart chart(const std::string& title, const ExactPair& pair)
{
  Curve similar;
  searchSimilar(pair, similar);
  const RaySearch rays(pair);
  Chart chart;
  chart.title = title;
  chart.xLabel = "heading - true heading, deg";
  chart.yLabel = "error / largest error";
  chart.yRange = {0, 1};
  chart.series = {scaled("every ray, absolute error", rays.absolute),
                  scaled("every ray, squared error", rays.squared),
                  scaled("similar segments, matching error", similar)};
  return chart;
}

/** Finds the pairs for the figure: those whose rays agree best and worst at the truth. */
class Extremes
{
 public:
  void add(const ExactPair& pair)
  {
    const double error_m = compareRays(pair, pair.T_ref_cur).absolute_m;
    if (error_m < least_m_) best_ = pair;
    if (error_m > most_m_) worst_ = pair;
    least_m_ = std::min(least_m_, error_m);
    most_m_ = std::max(most_m_, error_m);
  }

  const ExactPair& best() const { return best_; }
  const ExactPair& worst() const { return worst_; }

 private:
  ExactPair best_, worst_;
  double least_m_ = std::numeric_limits<double>::infinity(), most_m_ = -1;
};
}  // namespace

OrientationExperiment orientationExperiment(unsigned seed)
{
  OrientationExperiment experiment;
  experiment.pairs = kPairs;
  PairCaster caster(seed);
  Extremes extremes;
  Curve similar;
  for (int k = 0; k < kPairs; ++k)
  {
    const ExactPair pair = caster.next();
    const RaySearch rays(pair);
    count(experiment.similar, searchSimilar(pair, similar));
    count(experiment.absolute, miss_rad(rays.absolute));
    count(experiment.squared, miss_rad(rays.squared));
    extremes.add(pair);
  }
  experiment.figure.title = "Orientation search on exact scans from true positions";
  experiment.figure.panels = {chart("No bad associations", extremes.best()),
                              chart("Bad associations", extremes.worst())};
  return experiment;
}
}  // namespace psmks
