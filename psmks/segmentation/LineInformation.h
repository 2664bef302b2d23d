/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Line.h>

#include <Eigen/Core>
#include <algorithm>

namespace psmks
{
/** What the line filters need of a ray. */
struct MeasuredRay
{
  double cosine, sine;  //!< of its bearing
  double range_m;
  double inverseRange_1_m;
};

/** The Kalman filter of a line in information form.
 *
 * A ray of direction e = (cos b, sin b) that meets the line n.p = r0 has the inverse range 1/r =
 * u.e with u = n / r0, which is exactly linear in u: equation (1) of docs/derivations.md. The
 * variance of the inverse range is sigma^2 / r^4, so that the weight is w = r^4 / sigma^2. The sums
 * over a set of rays
 *
 *     M = sum w e e',   v = sum w e / r,   q = sum w / r^2
 *
 * give u = M^-1 v and chi2 = q - v'u. They are additive: a Kalman update is an addition, a ray is
 * dropped by a subtraction, and two lines are joined by adding their sums.
 *
 * The sums are kept for sigma = 1 m. A caller multiplies covariances by the true variance of a
 * range, and divides chi2 by it. Where the noise grows with the range, moments have to be
 * multiplied by RangeNoise::weightAt() first; sigma then is the standard deviation of short ranges.
 */
class LineInformation
{
 public:
  /** What one ray adds to the sums: three entries of M, two of v, and q. */
  using Moments = Eigen::Array<double, 6, 1>;

  static Moments moments(double cosine, double sine, double range_m)
  {
    const double r2 = range_m * range_m, wOverR = r2 * range_m;
    const double wc = r2 * r2 * cosine, ws = r2 * r2 * sine;
    Moments m;
    m << wc * cosine, wc * sine, ws * sine, wOverR * cosine, wOverR * sine, r2;
    return m;
  }
  static Moments moments(const MeasuredRay& ray)
  {
    return moments(ray.cosine, ray.sine, ray.range_m);
  }

  void add(const MeasuredRay& ray) { addMoments(moments(ray)); }

  void addMoments(const Moments& ray)
  {
    sums_ += ray;
    ++rays_;
  }
  void removeMoments(const Moments& ray)
  {
    sums_ -= ray;
    --rays_;
  }

  /** Adds consecutive rays. */
  void addMoments(const Moments* rays, int count)
  {
    for (int k = 0; k < count; ++k) sums_ += rays[k];
    rays_ += count;
  }

  LineInformation& operator+=(const LineInformation& other)
  {
    sums_ += other.sums_;
    rays_ += other.rays_;
    return *this;
  }

  int rays() const { return rays_; }

  /** The line that the sums give. */
  struct Solution
  {
    double u0, u1;         //!< u = n / r0, 1/m
    double p00, p01, p11;  //!< M^-1, the covariance of u for sigma = 1 m
    double chi2;           //!< sum of the squared range residuals to first order, m^2

    /** Inverse range of the line in a direction, 1/m. */
    double inverseRange(double cosine, double sine) const { return u0 * cosine + u1 * sine; }

    /** Variance of inverseRange() for ranges with a standard deviation of 1 m. */
    double inverseRangeVariance(double cosine, double sine) const
    {
      return cosine * cosine * p00 + 2 * cosine * sine * p01 + sine * sine * p11;
    }

    /** The line in polar form, with its covariance for ranges of the given variance. */
    Line line(double variance_m2) const
    {
      Line line;
      line.r0_m = 1 / std::hypot(u0, u1);
      line.phi0_rad = std::atan2(u1, u0);
      // J is the derivative of (r0, phi0) by u, with |u| = 1 / r0.
      const double r2 = line.r0_m * line.r0_m, r3 = r2 * line.r0_m;
      Eigen::Matrix2d J, inverse;
      J << -u0 * r3, -u1 * r3, -u1 * r2, u0 * r2;
      inverse << p00, p01, p01, p11;
      line.covariance = variance_m2 * J * inverse * J.transpose();
      return line;
    }
  };

  /** Computes the line of the sums.
   *  @return false where the rays do not fix a line: they have fewer than two directions */
  bool solve(Solution& s) const
  {
    const double m00 = sums_[0], m01 = sums_[1], m11 = sums_[2], v0 = sums_[3], v1 = sums_[4];
    const double determinant = m00 * m11 - m01 * m01;
    if (!(determinant > kSmallestDeterminant * m00 * m11) || rays_ < 2) return false;
    const double inverse = 1 / determinant;
    s.p00 = m11 * inverse, s.p01 = -m01 * inverse, s.p11 = m00 * inverse;
    s.u0 = s.p00 * v0 + s.p01 * v1;
    s.u1 = s.p01 * v0 + s.p11 * v1;
    s.chi2 = std::max(0.0, sums_[5] - (v0 * s.u0 + v1 * s.u1));
    return true;
  }

  /** Solution::chi2 without the rest; 0 where the rays do not fix a line. */
  double chi2_m2() const
  {
    const double m00 = sums_[0], m01 = sums_[1], m11 = sums_[2], v0 = sums_[3], v1 = sums_[4];
    const double determinant = m00 * m11 - m01 * m01;
    if (!(determinant > kSmallestDeterminant * m00 * m11) || rays_ < 2) return 0;
    const double explained = m11 * v0 * v0 - 2 * m01 * v0 * v1 + m00 * v1 * v1;
    return std::max(0.0, sums_[5] - explained / determinant);
  }

 private:
  /** Smallest determinant of M that fixes a line, as a share of the product of its diagonal. Unit:
   * share. Definition: two rays an angle d apart leave sin(d)^2; below 1e-12 it is the rounding of
   * doubles. */
  static constexpr double kSmallestDeterminant = 1e-12;

  Moments sums_ = Moments::Zero();
  int rays_ = 0;
};
}  // namespace psmks
