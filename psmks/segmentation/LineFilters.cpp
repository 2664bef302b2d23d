/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/segmentation/LineFilters.h>

namespace psmks
{
bool PolarLineFilter::start(const LineInformation& seed)
{
  LineInformation::Solution s{};
  if (!seed.solve(s)) return false;
  const Line line = s.line(noise_.sigma_m * noise_.sigma_m);
  r0_m_ = line.r0_m;
  phi0_rad_ = line.phi0_rad;
  P_ = line.covariance;
  return true;
}

PolarLineFilter::Linearisation PolarLineFilter::linearise(const MeasuredRay& ray) const
{
  const double c0 = std::cos(phi0_rad_), s0 = std::sin(phi0_rad_);
  const double c = ray.cosine * c0 + ray.sine * s0;  // cos(b - phi0)
  const double s = ray.sine * c0 - ray.cosine * s0;  // sin(b - phi0)
  const double inverse = c > 0 ? 1 / c : 0;
  return {r0_m_ * inverse, {inverse, -r0_m_ * s * inverse * inverse}};
}

bool PolarLineFilter::accepts(const MeasuredRay& ray, double gate) const
{
  const Linearisation l = linearise(ray);
  const double variance_m2 = noise_.varianceAt_m2(l.range_m) + (l.H * P_ * l.H.transpose())(0);
  const double innovation_m = ray.range_m - l.range_m;
  return l.range_m > 0 && innovation_m * innovation_m < gate * gate * variance_m2;
}

void PolarLineFilter::update(const MeasuredRay& ray)
{
  const Linearisation l = linearise(ray);
  const Eigen::Vector2d PHt = P_ * l.H.transpose();
  const double rangeVariance_m2 = noise_.varianceAt_m2(l.range_m);
  const double S = rangeVariance_m2 + (l.H * PHt)(0);
  const Eigen::Vector2d K = PHt / S;
  const double innovation_m = ray.range_m - l.range_m;
  r0_m_ += K(0) * innovation_m;
  phi0_rad_ += K(1) * innovation_m;
  // The Joseph form of the update keeps the covariance symmetric and positive.
  const Eigen::Matrix2d IKH = Eigen::Matrix2d::Identity() - K * l.H;
  P_ = IKH * P_ * IKH.transpose() + rangeVariance_m2 * K * K.transpose();
}

Line PolarLineFilter::line() const { return Line::fromNormalForm(r0_m_, phi0_rad_, P_); }
}  // namespace psmks
