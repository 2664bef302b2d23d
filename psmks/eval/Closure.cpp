/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/eval/Closure.h>

#include <Eigen/LU>
#include <cmath>
#include <functional>

namespace psmks
{
namespace
{
/** A match that leaves nothing open. */
bool isWhole(const MatchResult& result)
{
  return result.usable() && !result.unobservableDirection && !result.headingUnobservable &&
         !result.ambiguity;
}

/** Noise of the rays of a scan in standard deviations: a moving mean of white noise, scaled. */
std::vector<double> smoothedNoise(std::size_t rays, std::size_t width, std::mt19937_64& random)
{
  std::normal_distribution<double> unit;
  std::vector<double> white(rays + width - 1), noise(rays, 0);
  for (double& n : white) n = unit(random);
  for (std::size_t ray = 0; ray < rays; ++ray)
    for (std::size_t k = 0; k < width; ++k)
      noise[ray] += white[ray + k] / std::sqrt(static_cast<double>(width));
  return noise;
}

Eigen::Matrix3d covarianceOf(const std::vector<Eigen::Vector3d>& errors)
{
  const auto n = static_cast<double>(errors.size());
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& error : errors) mean += error / n;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& error : errors)
    covariance += (error - mean) * (error - mean).transpose() / (n - 1);
  return covariance;
}

/** The root of a falling function that is above 0 at 0; 0 where it is not. */
double rootOf(const std::function<double(double)>& function, double largest)
{
  constexpr int kHalvings = 40;
  if (function(0) <= 0) return 0;
  double low = 0, high = largest;
  for (int i = 0; i < kHalvings; ++i)
  {
    const double middle = (low + high) / 2;
    (function(middle) > 0 ? low : high) = middle;
  }
  return (low + high) / 2;
}
}  // namespace

Eigen::Vector3d ClosureExperiment::Triangle::error() const
{
  const Pose2 missed = T_a_b * T_b_c * T_a_c.inverse();
  return {missed.x_m, missed.y_m, missed.phi_rad};
}

std::optional<Closure> ClosureExperiment::close(const Scan& a, const Scan& b, const Scan& c,
                                                const Pose2& T_a_b, const Pose2& T_b_c)
{
  const Scan* const measured[] = {&a, &b, &c};
  for (std::size_t s = 0; s < 3; ++s) matcher_.segment(*measured[s], workspace_, scans_[s]);
  const auto triangle = matched({T_a_b, T_b_c, T_a_b * T_b_c});
  if (!triangle) return std::nullopt;

  const std::vector<SegmentedScan> segmented(std::begin(scans_), std::end(scans_));
  std::vector<Eigen::Vector3d> errors;
  for (int draw = 0; draw < draws_; ++draw)
  {
    for (std::size_t s = 0; s < 3; ++s)
      matcher_.segment(withNewNoise(*measured[s], segmented[s]), workspace_, scans_[s]);
    const auto noisy = matched(*triangle);
    if (!noisy) return std::nullopt;
    errors.push_back(noisy->error());
  }
  return Closure{triangle->error(), covarianceOf(errors)};
}

std::optional<ClosureExperiment::Triangle> ClosureExperiment::matched(const Triangle& starts)
{
  const auto T_a_b = matched(0, 1, starts.T_a_b), T_b_c = matched(1, 2, starts.T_b_c);
  const auto T_a_c = matched(0, 2, starts.T_a_c);
  if (!T_a_b || !T_b_c || !T_a_c) return std::nullopt;
  return Triangle{*T_a_b, *T_b_c, *T_a_c};
}

std::optional<Pose2> ClosureExperiment::matched(std::size_t reference, std::size_t current,
                                                const Pose2& start)
{
  const MatchResult result = matcher_.match(scans_[reference], scans_[current], {start, {}},
                                            workspace_, nullptr, SearchScope::NearGuess);
  return isWhole(result) ? std::make_optional(result.T_ref_cur) : std::nullopt;
}

Scan ClosureExperiment::withNewNoise(const Scan& scan, const SegmentedScan& segmented)
{
  Scan noisy = scan;
  noisy.grid = segmented.grid;
  noisy.range_m = segmented.range_m;
  noisy.valid = segmented.valid;
  const auto width = static_cast<std::size_t>(std::lround(segmented.raysPerReading));
  const std::vector<double> noise = smoothedNoise(noisy.range_m.size(), width, random_);
  for (std::size_t ray = 0; ray < noise.size(); ++ray)
    if (segmented.valid[ray] != 0)
      noisy.range_m[ray] = segmented.denoisedRange_m(static_cast<int>(ray)) +
                           noise[ray] * segmented.rangeNoise.sigmaAt_m(segmented.range_m[ray]);
  return noisy;
}

double ClosureExperiment::normalizedSquare(const Closure& closure) const
{
  constexpr double kLost = 5;
  return (draws_ - kLost) / (draws_ - 1) *
         closure.error.dot(closure.covariance.inverse() * closure.error);
}

MissingSigma missingSigma(const std::vector<Closure>& closures, int draws)
{
  // The inverse of a sampled covariance is too large on average, by the more, the more coordinates.
  const double scale_xy = (draws - 1.0) / (draws - 4), scale_phi = (draws - 1.0) / (draws - 3);
  constexpr double kMatches = 3, kLargest_m = 1, kLargest_rad = 1;
  const auto excess_m = [&](double sigma_m)
  {
    const Eigen::Matrix2d added = kMatches * sigma_m * sigma_m * Eigen::Matrix2d::Identity();
    double sum = 0;
    for (const Closure& c : closures)
    {
      const Eigen::Vector2d e = c.error.head<2>();
      const Eigen::Matrix2d S = scale_xy * c.covariance.topLeftCorner<2, 2>() + added;
      sum += e.dot(S.inverse() * e) - 2;
    }
    return sum;
  };
  const auto excess_rad = [&](double sigma_rad)
  {
    double sum = 0;
    for (const Closure& c : closures)
      sum += c.error.z() * c.error.z() /
                 (scale_phi * c.covariance(2, 2) + kMatches * sigma_rad * sigma_rad) -
             1;
    return sum;
  };
  return {rootOf(excess_m, kLargest_m), rootOf(excess_rad, kLargest_rad)};
}
}  // namespace psmks
