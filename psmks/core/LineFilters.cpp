/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/core/LineFilters.h>

namespace psmks
{
bool LinearLineFilter::start(const LineSums& seed)
{
  sums_ = seed;
  return sums_.solve(solution_);
}

RangePrediction LinearLineFilter::predict(double cosine, double sine) const
{
  const double inverse = solution_.inverseRange(cosine, sine);
  if (!(inverse > 0)) return {};
  const double range_m = 1 / inverse;
  const double r2 = range_m * range_m;
  // var(r) = r^4 var(1/r)
  const double variance =
      variance_m2_ * (1 + r2 * r2 * solution_.inverseRangeVariance(cosine, sine));
  return {range_m, variance};
}

void LinearLineFilter::update(double cosine, double sine, double range_m)
{
  sums_.add(cosine, sine, range_m);
  sums_.solve(solution_);
}

bool PolarLineFilter::start(const LineSums& seed)
{
  LineSums::Solution s{};
  if (!seed.solve(s)) return false;
  const Line line = s.line();
  r0_m_ = line.r0_m;
  phi0_rad_ = line.phi0_rad;
  // d(r0, phi0)/du with |u| = 1/r0
  const double r2 = r0_m_ * r0_m_;
  Eigen::Matrix2d J;
  J << -s.u0 * r2 * r0_m_, -s.u1 * r2 * r0_m_, -s.u1 * r2, s.u0 * r2;
  Eigen::Matrix2d inverse;
  inverse << s.p00, s.p01, s.p01, s.p11;
  P_ = variance_m2_ * J * inverse * J.transpose();
  return true;
}

PolarLineFilter::Linearisation PolarLineFilter::linearise(double cosine, double sine) const
{
  const double c0 = std::cos(phi0_rad_), s0 = std::sin(phi0_rad_);
  const double c = cosine * c0 + sine * s0;  // cos(b - phi0)
  const double s = sine * c0 - cosine * s0;  // sin(b - phi0)
  const double inverse = c > 0 ? 1 / c : 0;
  return {r0_m_ * inverse, {inverse, -r0_m_ * s * inverse * inverse}};
}

RangePrediction PolarLineFilter::predict(double cosine, double sine) const
{
  const Linearisation l = linearise(cosine, sine);
  return {l.range_m, variance_m2_ + (l.H * P_ * l.H.transpose())(0)};
}

void PolarLineFilter::update(double cosine, double sine, double range_m)
{
  const Linearisation l = linearise(cosine, sine);
  const Eigen::Vector2d PHt = P_ * l.H.transpose();
  const double S = variance_m2_ + (l.H * PHt)(0);
  const Eigen::Vector2d K = PHt / S;
  const double innovation_m = range_m - l.range_m;
  r0_m_ += K(0) * innovation_m;
  phi0_rad_ += K(1) * innovation_m;
  // Joseph form: stays symmetric and positive
  const Eigen::Matrix2d IKH = Eigen::Matrix2d::Identity() - K * l.H;
  P_ = IKH * P_ * IKH.transpose() + variance_m2_ * K * K.transpose();
}

Line PolarLineFilter::line() const { return Line::fromNormalForm(r0_m_, phi0_rad_, P_); }
}  // namespace psmks
