/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/RangeNoise.h>
#include <psmks/segmentation/RaySoA.h>

namespace psmks
{
/** Kalman filter over consecutive rays, exactly linear: the state u = n / r0 measured by 1/r
 *  (LineInformation). No start guess, no linearisation.
 *
 * Differs from the paper: its filter is the extended one below, which is inconsistent when started
 * from a few rays (docs/algorithm.md). */
class LinearLineFilter
{
 public:
  explicit LinearLineFilter(const RangeNoise& noise)
      : variance_m2_(noise.sigma_m * noise.sigma_m), growth_1_m2_(noise.growth_1_m2())
  {
  }

  /** Starts from the sums of a few rays, weighed as RaySoA does; false where they fix no line.
   */
  bool start(const LineInformation& seed)
  {
    if (!seed.solve(solution_)) return false;
    widen();
    return true;
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

  /** A line of many rays hardly changes by one more: it may take a block of rays at once, all held
   * against the line as it was. The gate stays right, for the variance is that of the older,
   * slightly less certain line. */
  static bool takesBlocks(const LineInformation& sums)
  {
    constexpr int kManyRays = 8;
    return sums.rays() >= kManyRays;
  }

  /** Whether every ray of a block is accepted. */
  bool acceptsBlock(const RaySoA& rays, int position, double gate) const
  {
    using Block = RaySoA::Block;
    const Block cosine = RaySoA::block(rays.cosine, position);
    const Block sine = RaySoA::block(rays.sine, position);
    const Block expected = solution_.u0 * cosine + solution_.u1 * sine;
    const Block line = cosine * (solution_.p00 * cosine + 2 * solution_.p01 * sine) +
                       solution_.p11 * sine.square();
    const Block variance = variance_m2_ * (expected.square().square() + line);
    const Block innovation = RaySoA::block(rays.inverseRange_1_m, position) - expected;
    const Block spare = gate * gate * variance - innovation.square();
    return spare.min(expected).minCoeff() > 0;
  }

  /** @param sums of all rays up to now, with the new ones */
  void update(const MeasuredRay&, const LineInformation& sums) { update(sums); }
  void update(const LineInformation& sums)
  {
    if (sums.solve(solution_)) widen();
  }

 private:
  /** Where the noise grows, a ray's var(1/r) is larger by growth sigma^2 / r^2 with 1/r = u.e: a
   * quadratic form of its direction e, like the variance of the line, and counted with that. */
  void widen()
  {
    if (growth_1_m2_ == 0) return;
    LineInformation::Solution& s = solution_;
    s.p00 += growth_1_m2_ * s.u0 * s.u0;
    s.p01 += growth_1_m2_ * s.u0 * s.u1;
    s.p11 += growth_1_m2_ * s.u1 * s.u1;
  }

  double variance_m2_, growth_1_m2_;
  LineInformation::Solution solution_{};
};

/** The paper's extended Kalman filter on (r0, phi0) with the measurement r = r0 / cos(b - phi0). */
class PolarLineFilter
{
 public:
  explicit PolarLineFilter(const RangeNoise& noise) : noise_(noise) {}

  bool start(const LineInformation& seed);
  bool accepts(const MeasuredRay& ray, double gate) const;
  void update(const MeasuredRay& ray);
  void update(const MeasuredRay& ray, const LineInformation&) { update(ray); }

  /** The state with its covariance. */
  Line line() const;

 private:
  struct Linearisation
  {
    double range_m;        //!< expected; 0 where the ray does not meet the line
    Eigen::RowVector2d H;  //!< d range / d (r0, phi0)
  };
  Linearisation linearise(const MeasuredRay& ray) const;

  RangeNoise noise_;
  double r0_m_ = 0, phi0_rad_ = 0;
  Eigen::Matrix2d P_ = Eigen::Matrix2d::Zero();
};
}  // namespace psmks
