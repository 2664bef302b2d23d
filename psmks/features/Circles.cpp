/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/features/Circles.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
/** Fewest rays of a circle. Unit: rays. Definition: three fix a circle, the fourth tests it. */
constexpr int kFewestRays = 4;

/** Largest difference of the ranges of neighbouring rays on one object. Evidence: measured. */
constexpr double kLargestStep_m = 0.3;

/** A segment shorter than this may be part of an arc. Evidence: measured. */
constexpr double kShortWall_m = 0.8;

/** Smallest radius. Evidence: measured. */
constexpr double kSmallest_m = 0.02;

/** Largest radius. Evidence: measured. */
constexpr double kLargest_m = 1.5;

/** Chi2 that a bend has to gain over a straight line. Unit: chi2. Evidence: three standard
 * deviations with 1 degree of freedom. */
constexpr double kBent = 9;

/** Chi2 of a circle may exceed its mean by so many standard deviations. Unit: standard deviations.
 * Evidence: measured. */
constexpr double kMisfit = 3;

/** Largest standard deviation of a radius; a circle known worse is not linear in its errors.
 * Evidence: measured. */
constexpr double kRadiusSigma_m = 0.1;

/** Most Gauss-Newton steps of a fit. Unit: steps. Evidence: measured. */
constexpr int kSteps = 2;

/** A fit has settled once a step gains less than this. Unit: chi2. Evidence: chance moves chi2 by
 * more than 1. */
constexpr double kSettled = 0.1;

/** Smallest squared cosine of incidence in the weight of a ray besides what its noise explains.
 * Unit: squared cosine. Evidence: measured. */
constexpr double kGrazing = 0.01;

/** Share of the relative range variance in the smallest squared cosine of incidence. At grazing
 * incidence the noise moves a point along the circle and off its bend. Unit: share. Evidence:
 * measured. */
constexpr double kBendOfNoise = 0.75;

/** A circle while it is fitted. */
struct Fit
{
  Eigen::Vector2d centre_m = Eigen::Vector2d::Zero();
  double radius_m = 0;
  Eigen::Matrix3d information;  //!< of (centre, radius)
  Eigen::Vector3d gradient;     //!< information * gradient is the step to the minimum
  double chi2 = 0;
};

/** Sums of the regression x = f + a y + k q with q = (x^2 + y^2) / 2 over the points of a run,
 * which gives the first estimate of a circle. */
class BendSums
{
 public:
  void add(double x, double y)
  {
    const double q = (x * x + y * y) / 2;
    n_ += 1, y_ += y, q_ += q, x_ += x;
    yy_ += y * y, yq_ += y * q, qq_ += q * q, xy_ += x * y, xq_ += x * q;
  }

  /** Solves the regression.
   *  @param chi2_m2 what the bend has to take off the sum of the squared residuals
   *  @return false where it takes off less, or bends towards the scanner like the inside of a
   * circle */
  bool solve(double chi2_m2, double& f, double& a, double& k) const
  {
    const double yy = yy_ - y_ * y_ / n_, yq = yq_ - y_ * q_ / n_, qq = qq_ - q_ * q_ / n_;
    const double xy = xy_ - x_ * y_ / n_, xq = xq_ - x_ * q_ / n_;
    const double slope = yq / yy, free = qq - slope * yq, bend = xq - slope * xy;
    if (!(free > 0) || !(bend > 0) || bend * bend < chi2_m2 * free) return false;
    k = bend / free;
    a = (xy - k * yq) / yy;
    f = (x_ - a * y_ - k * q_) / n_;
    return true;
  }

 private:
  double n_ = 0, y_ = 0, q_ = 0, x_ = 0, yy_ = 0, yq_ = 0, qq_ = 0, xy_ = 0, xq_ = 0;
};

/** Finds the circles of a scan, run by run of neighbouring rays. */
class CircleFinder
{
 public:
  CircleFinder(const SegmentedScan& scan, std::vector<Circle>& circles,
               std::vector<int>& circleOfRay)
      : scan_(scan), circles_(circles), circleOfRay_(circleOfRay)
  {
  }

  void run()
  {
    for (int first = 0; first < scan_.rays() && circles_.size() < kMostCircles;)
    {
      if (const Segment* segment = scan_.segmentAt(first); segment && isLong(*segment))
      {
        first = scan_.rayAfter(*segment, first);
        continue;
      }
      int end = first;
      while (end < scan_.rays() && mayBeRound(end) && (end == first || isJoined(end))) ++end;
      if (end - first >= kFewestRays && !isOneSegment(first, end - 1)) tryRun(first, end - 1);
      first = std::max(end, first + 1);
    }
  }

 private:
  double range_m(int ray) const { return scan_.range_m[static_cast<std::size_t>(ray)]; }

  /** Whether a ray is valid and on no long segment. A near arc is segmented into several short
   * ones. */
  bool mayBeRound(int ray) const
  {
    if (!scan_.isValid(ray)) return false;
    const Segment* segment = scan_.segmentAt(ray);
    return !segment || !isLong(*segment);
  }

  static bool isLong(const Segment& segment)
  {
    return (segment.lastEnd_m - segment.firstEnd_m).squaredNorm() >= kShortWall_m * kShortWall_m;
  }

  /** Whether a ray and the one before it may be on one object. */
  bool isJoined(int ray) const
  {
    return std::abs(range_m(ray) - range_m(ray - 1)) < kLargestStep_m;
  }

  /** Whether a run is exactly one segment, and so straight. */
  bool isOneSegment(int first, int last) const
  {
    const Segment* segment = scan_.segmentAt(first);
    return segment && segment->firstRay == first && segment->lastRay == last;
  }

  /** Fits a circle to a run and keeps it if it fits. */
  void tryRun(int first, int last)
  {
    variance_m2_ = scan_.rangeVarianceOf_m2((first + last) / 2);
    Fit fit;
    if (!start(first, last, fit)) return;
    double gain = 2 * kSettled;
    for (int k = 0; k < kSteps && gain > kSettled; ++k)
      if (!step(first, last, fit, gain)) return;
    if (fits(fit, last - first + 1)) keep(fit, first, last);
  }

  /** Estimates the circle k/2 (x^2 + y^2) + a y - x + f = 0 by linear regression, with x along the
   * middle ray and the origin at its end. The gradient of the left side has the same length all
   * round the circle, so that all residuals have the same weight.
   *  @return false where the run is straight, or bends like the inside of a circle */
  bool start(int first, int last, Fit& fit) const
  {
    const int middle = (first + last) / 2;
    const Eigen::Vector2d ahead = scan_.grid.direction(middle), left(-ahead.y(), ahead.x());
    BendSums sums;
    for (int ray = first; ray <= last; ++ray)
    {
      const Eigen::Vector2d p_m = scan_.point_m(ray);
      sums.add(ahead.dot(p_m) - range_m(middle), left.dot(p_m));
    }
    double f, a, k;
    if (!sums.solve(kBent * variance_m2_, f, a, k)) return false;
    const double radius2_m2 = (1 + a * a) / (k * k) - 2 * f / k;
    if (!(radius2_m2 > 0) || k < 1 / (2 * kLargest_m)) return false;
    fit.radius_m = std::clamp(std::sqrt(radius2_m2), kSmallest_m, kLargest_m);
    fit.centre_m = (range_m(middle) + 1 / k) * ahead - a / k * left;
    return true;
  }

  /** Makes one Gauss-Newton step.
   *  @param[out] gain what the step takes off chi2
   *  @return false where it leads to a radius that is too small or too large */
  bool step(int first, int last, Fit& fit, double& gain) const
  {
    linearise(first, last, fit);
    const Eigen::Vector3d by = fit.information.inverse() * fit.gradient;
    fit.centre_m += by.head<2>();
    fit.radius_m += by[2];
    gain = fit.gradient.dot(by);
    fit.chi2 -= gain;
    return fit.radius_m > kSmallest_m && fit.radius_m < kLargest_m;
  }

  /** Computes the normal equations of a fit (docs/derivations.md, "Circles"). The residual of a ray
   * is the distance of its end from the circle. Its derivatives by centre and radius are -(u, 1)
   * with the outward normal u where the ray meets the circle. Its standard deviation is that of the
   * range times the cosine of incidence. */
  void linearise(int first, int last, Fit& fit) const
  {
    const double R = fit.radius_m;
    const double least = kGrazing + kBendOfNoise * variance_m2_ / (R * R);
    fit.information.setZero();
    fit.gradient.setZero();
    fit.chi2 = 0;
    for (int ray = first; ray <= last; ++ray)
    {
      const Eigen::Vector2d e = scan_.grid.direction(ray), left(-e.y(), e.x());
      const double sine = std::clamp(-left.dot(fit.centre_m) / R, -1.0, 1.0);
      const double cosine2 = 1 - sine * sine;
      const Eigen::Vector2d u = sine * left - std::sqrt(cosine2) * e;
      const Eigen::Vector3d row(u.x(), u.y(), 1);
      const double residual_m = (scan_.point_m(ray) - fit.centre_m).norm() - R;
      const Eigen::Vector3d weighted = row / (variance_m2_ * (cosine2 + least));
      fit.information += weighted * row.transpose();
      fit.gradient += residual_m * weighted;
      fit.chi2 += residual_m * residual_m * weighted[2];
    }
  }

  /** Whether chi2 is within what its distribution allows. */
  static bool fits(const Fit& fit, int rays)
  {
    const double freedom = rays - 3;
    return fit.chi2 < freedom + kMisfit * std::sqrt(2 * freedom);
  }

  /** Adds a circle to the result if its radius is known well enough. */
  void keep(const Fit& fit, int first, int last)
  {
    const Eigen::Matrix3d covariance = scan_.raysPerReading * fit.information.inverse();
    const double radiusVariance_m2 = covariance(2, 2);
    if (!(radiusVariance_m2 > 0 && radiusVariance_m2 < kRadiusSigma_m * kRadiusSigma_m)) return;
    const auto begin = circleOfRay_.begin();
    std::fill(begin + first, begin + last + 1, static_cast<int>(circles_.size()));
    circles_.push_back({fit.centre_m, fit.radius_m, covariance, first, last});
  }

  const SegmentedScan& scan_;
  std::vector<Circle>& circles_;
  std::vector<int>& circleOfRay_;
  double variance_m2_ = 0;  //!< variance of a range of the run that is fitted
};
}  // namespace

void findCircles(const SegmentedScan& scan, std::vector<Circle>& circles,
                 std::vector<int>& circleOfRay)
{
  circles.clear();
  circleOfRay.assign(static_cast<std::size_t>(scan.rays()), -1);
  CircleFinder(scan, circles, circleOfRay).run();
}
}  // namespace psmks
