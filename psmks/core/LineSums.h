/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/core/Line.h>

#include <Eigen/Core>
#include <optional>

namespace psmks
{
/** A ray as the line filters see it. */
struct MeasuredRay
{
  double cosine, sine;  //!< of its bearing
  double range_m;
  double inverseRange_1_m;
};

/** The linear line filter in information form.
 *
 * With u = n / r0 a ray of direction e = (cos b, sin b) that meets the line has 1/r = u.e, exactly
 * linear in u (docs/algorithm.md; B.2 of the derivation). Its variance is sigma^2 / r^4, so the
 * weight is r^4 / sigma^2. The information sums of a set of rays,
 *
 *     M = sum w e e',   v = sum w e / r,   q = sum w / r^2,
 *
 * give u = M^-1 v and chi2 = q - v'u. They are additive: a Kalman update is an addition, a ray is
 * dropped by a subtraction, two lines are joined by adding their sums. Kept here for sigma = 1 m;
 * a caller divides chi2 and covariances by the variance it holds true. */
class LineSums
{
 public:
  void add(const MeasuredRay& ray) { accumulate(ray, 1); }
  void remove(const MeasuredRay& ray) { accumulate(ray, -1); }

  LineSums& operator+=(const LineSums& other)
  {
    m00_ += other.m00_, m01_ += other.m01_, m11_ += other.m11_;
    v0_ += other.v0_, v1_ += other.v1_, q_ += other.q_, rays_ += other.rays_;
    return *this;
  }

  int rays() const { return rays_; }

  /** u and the sums' inverse, for predictions. */
  struct Solution
  {
    double u0, u1;         //!< u = n / r0, 1/m
    double p00, p01, p11;  //!< M^-1
    double chi2;           //!< m^2: residual sum of squares in range, to first order

    double inverseRange(double cosine, double sine) const { return u0 * cosine + u1 * sine; }

    /** Variance of inverseRange() for sigma = 1 m. */
    double inverseRangeVariance(double cosine, double sine) const
    {
      return cosine * cosine * p00 + 2 * cosine * sine * p01 + sine * sine * p11;
    }

    /** As a line with its covariance, for ranges of the given variance. */
    Line line(double variance_m2) const
    {
      Line line;
      line.r0_m = 1 / std::hypot(u0, u1);
      line.phi0_rad = std::atan2(u1, u0);
      // d(r0, phi0)/du with |u| = 1 / r0
      const double r2 = line.r0_m * line.r0_m, r3 = r2 * line.r0_m;
      Eigen::Matrix2d J, inverse;
      J << -u0 * r3, -u1 * r3, -u1 * r2, u0 * r2;
      inverse << p00, p01, p01, p11;
      line.covariance = variance_m2 * J * inverse * J.transpose();
      return line;
    }
  };

  /** False where the rays do not fix a line (fewer than two directions). */
  bool solve(Solution& s) const
  {
    const double determinant = m00_ * m11_ - m01_ * m01_;
    // The smallest determinant two distinct rays leave: (w1 w2 sin^2) against rounding of w1 w2.
    if (!(determinant > 1e-12 * m00_ * m11_) || rays_ < 2) return false;
    const double inverse = 1 / determinant;
    s.p00 = m11_ * inverse, s.p01 = -m01_ * inverse, s.p11 = m00_ * inverse;
    s.u0 = s.p00 * v0_ + s.p01 * v1_;
    s.u1 = s.p01 * v0_ + s.p11 * v1_;
    s.chi2 = std::max(0.0, q_ - (v0_ * s.u0 + v1_ * s.u1));
    return true;
  }

 private:
  void accumulate(const MeasuredRay& ray, int sign)
  {
    const double r2 = ray.range_m * ray.range_m;
    const double w = sign * r2 * r2, wOverR = sign * r2 * ray.range_m;
    const double wc = w * ray.cosine, ws = w * ray.sine;
    m00_ += wc * ray.cosine, m01_ += wc * ray.sine, m11_ += ws * ray.sine;
    v0_ += wOverR * ray.cosine, v1_ += wOverR * ray.sine;
    q_ += sign * r2;
    rays_ += sign;
  }

  double m00_ = 0, m01_ = 0, m11_ = 0, v0_ = 0, v1_ = 0, q_ = 0;
  int rays_ = 0;
};
}  // namespace psmks
