/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/RangeNoise.h>
#include <psmks/segmentation/RaySoA.h>

namespace psmks
{
/** Kalman filter of a line over consecutive rays. Its state is u = n / r0 and its measurement the
 * inverse range, which is exactly linear in u: equation (1) of docs/derivations.md. It needs
 * neither a start value nor a linearisation.
 *
 * Differs from the paper: the paper's filter is PolarLineFilter, whose covariance comes out too
 * small when it is started from a few rays (docs/derivations.md, "Lines"). */
class LinearLineFilter
{
 public:
  explicit LinearLineFilter(const RangeNoise& noise)
      : variance_m2_(noise.sigma_m * noise.sigma_m), growth_1_m2_(noise.growth_1_m2())
  {
  }

  /** Starts the filter from a few rays.
   *  @param seed the sums of their moments, weighted as in RaySoA::moments
   *  @return false where they do not fix a line */
  bool start(const LineInformation& seed)
  {
    if (!seed.solve(solution_)) return false;
    widen();
    return true;
  }

  /** Whether the innovation of a ray is within `gate` of its standard deviations. */
  bool accepts(const MeasuredRay& ray, double gate) const
  {
    const double expected = solution_.inverseRange(ray.cosine, ray.sine);
    const double expected2 = expected * expected;
    // The variance sigma^2 / r^4 of the ray's inverse range, plus that of the line's prediction.
    const double variance = variance_m2_ * (expected2 * expected2 +
                                            solution_.inverseRangeVariance(ray.cosine, ray.sine));
    const double innovation = ray.inverseRange_1_m - expected;
    return expected > 0 && innovation * innovation < gate * gate * variance;
  }

  /** Whether a line has so many rays that one more hardly changes it. It may then take a block of
   * rays at once, each tested against the line without the others of the block. The gate stays
   * correct, because the variance in it is that of the same, slightly less certain line. */
  static bool takesBlocks(const LineInformation& sums)
  {
    /** Fewest rays of a line that takes whole blocks. Unit: rays. Evidence: measured. */
    constexpr int kManyRays = 8;
    return sums.rays() >= kManyRays;
  }

  /** Whether the filter accepts every ray of the block that begins at a position. */
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

  /** Updates the line. The sums hold all that the filter needs; the single ray is an argument
   * because the other filter takes it.
   *  @param sums of all rays of the line, the new ones included */
  void update(const MeasuredRay&, const LineInformation& sums) { update(sums); }
  void update(const LineInformation& sums)
  {
    if (sums.solve(solution_)) widen();
  }

 private:
  /** Adds to the variance of the prediction what growing noise adds to that of a ray. Where the
   * noise grows with the range, the variance of a ray's inverse range is larger by growth sigma^2 /
   * r^2 with 1/r = u.e. That is a quadratic form of the ray's direction e, as the variance of the
   * prediction is, so that both are kept in one matrix. */
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

/** The paper's extended Kalman filter on (r0, phi0) with the measurement r = r0 / cos(b - phi0)
 * (paper, section 2.1). */
class PolarLineFilter
{
 public:
  explicit PolarLineFilter(const RangeNoise& noise) : noise_(noise) {}

  /** Starts the filter at the line that a few rays fix, with its covariance.
   *  @return false where they do not fix a line */
  bool start(const LineInformation& seed);

  /** Whether the innovation of a ray is within `gate` of its standard deviations; false where the
   * ray does not meet the line. */
  bool accepts(const MeasuredRay& ray, double gate) const;

  void update(const MeasuredRay& ray);

  /** The same update in the form that LineGrowing calls for either filter. */
  void update(const MeasuredRay& ray, const LineInformation&) { update(ray); }

  /** The state and its covariance as a line. */
  Line line() const;

 private:
  struct Linearisation
  {
    double range_m;        //!< of the line at the ray's bearing; 0 where the ray does not meet it
    Eigen::RowVector2d H;  //!< derivative of that range by (r0, phi0)
  };
  Linearisation linearise(const MeasuredRay& ray) const;

  RangeNoise noise_;
  double r0_m_ = 0, phi0_rad_ = 0;
  Eigen::Matrix2d P_ = Eigen::Matrix2d::Zero();
};
}  // namespace psmks
