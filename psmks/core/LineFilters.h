/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/core/LineSums.h>

namespace psmks
{
/** Kalman filter over consecutive rays, exactly linear: the state u = n / r0 measured by 1/r
 *  (LineSums). No start guess, no linearisation.
 *
 * Differs from the paper: its filter is the extended one below, which is inconsistent when started
 * from a few rays (docs/algorithm.md). */
class LinearLineFilter
{
 public:
  explicit LinearLineFilter(double sigma_m) : variance_m2_(sigma_m * sigma_m) {}

  /** Starts from the sums of a few rays; false where they fix no line. */
  bool start(const LineSums& seed)
  {
    sums_ = seed;
    return sums_.solve(solution_);
  }

  /** Whether the ray's innovation is within `gate` standard deviations. */
  bool accepts(const MeasuredRay& ray, double gate) const
  {
    const double expected = solution_.inverseRange(ray.cosine, ray.sine);
    const double expected2 = expected * expected;
    // var(1/r) = sigma^2 / r^4 of the ray, plus what the line itself is uncertain by
    const double variance = variance_m2_ * (expected2 * expected2 +
                                            solution_.inverseRangeVariance(ray.cosine, ray.sine));
    const double innovation = ray.inverseRange_1_m - expected;
    return expected > 0 && innovation * innovation < gate * gate * variance;
  }

  void update(const MeasuredRay& ray)
  {
    sums_.add(ray);
    // A line of many rays hardly changes by one more: it is solved anew at every fourth. The gate
    // stays right, for the variance is that of the older, slightly less certain line.
    constexpr int kManyRays = 12;
    if (sums_.rays() < kManyRays || sums_.rays() % 4 == 0) sums_.solve(solution_);
  }

 private:
  double variance_m2_;
  LineSums sums_;
  LineSums::Solution solution_{};
};

/** The paper's extended Kalman filter on (r0, phi0) with the measurement r = r0 / cos(b - phi0). */
class PolarLineFilter
{
 public:
  explicit PolarLineFilter(double sigma_m) : variance_m2_(sigma_m * sigma_m) {}

  bool start(const LineSums& seed);
  bool accepts(const MeasuredRay& ray, double gate) const;
  void update(const MeasuredRay& ray);

  /** The state with its covariance. */
  Line line() const;

 private:
  struct Linearisation
  {
    double range_m;        //!< expected; 0 where the ray does not meet the line
    Eigen::RowVector2d H;  //!< d range / d (r0, phi0)
  };
  Linearisation linearise(const MeasuredRay& ray) const;

  double variance_m2_;
  double r0_m_ = 0, phi0_rad_ = 0;
  Eigen::Matrix2d P_ = Eigen::Matrix2d::Zero();
};
}  // namespace psmks
