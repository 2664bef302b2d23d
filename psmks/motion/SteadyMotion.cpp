/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/motion/SteadyMotion.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace psmks
{
namespace
{
/** How many durations tell the usual one. Unit: motions. Definition: a median of nine is that of
 * the scanner where a few stamps jitter or a few scans are missing. */
constexpr std::size_t kDurations = 9;

/** Longest time between scans over which a robot is taken to go on. Unit: periods. Definition: two
 * scans may be missing; after more the robot may have done anything. */
constexpr double kLongestGap = 3.5;

/** A motion that goes on for a number of periods. Translation and rotation are those of one, each
 * times their number: an arc as long in between is near enough for a prediction. */
Pose2 times(double periods, const Pose2& motion)
{
  return {periods * motion.x_m, periods * motion.y_m, periods * motion.phi_rad};
}
}  // namespace

UncertainPose SteadyMotion::untilScan(double stamp_s)
{
  const std::optional<double> duration_s = sinceLastScan_s(stamp_s);
  const bool isKnown = std::exchange(isKnown_, false);
  if (!duration_s)
  {
    periods_ = 1;
    isGap_ = false;
    return unknown(isKnown ? T_per_period_ : Pose2());
  }
  durations_s_.push_back(*duration_s);
  if (durations_s_.size() > kDurations) durations_s_.pop_front();
  const double period_s = usualPeriod_s();
  isGap_ = *duration_s > kLongestGap * period_s;
  periods_ = isGap_ ? 1 : std::max(1, static_cast<int>(std::lround(*duration_s / period_s)));
  if (!isKnown || isGap_) return unknown({});

  const double motion_s = periods_ * period_s, growth_s2 = motion_s * motion_s;
  const double sigma_m = options_.minSigma_m + options_.accelerationSigma_m_s2 * growth_s2;
  const double sigma_rad = options_.minSigma_rad + options_.accelerationSigma_rad_s2 * growth_s2;
  return {times(periods_, T_per_period_),
          diagonalCovariance(std::min(sigma_m, options_.unknownSigma_m),
                             std::min(sigma_rad, options_.unknownSigma_rad))};
}

void SteadyMotion::learn(const Pose2& T_before_last)
{
  if (isGap_) return;
  T_per_period_ = times(1.0 / periods_, T_before_last);
  isKnown_ = true;
}

/** The time since the scan before; none where it is not known or not positive. */
std::optional<double> SteadyMotion::sinceLastScan_s(double stamp_s)
{
  const auto before_s = lastStamp_s_;
  lastStamp_s_ = stamp_s;
  if (!before_s || !(stamp_s > *before_s) || !std::isfinite(stamp_s - *before_s))
    return std::nullopt;
  return stamp_s - *before_s;
}

/** The usual time between scans, of one motion at least. */
double SteadyMotion::usualPeriod_s() const
{
  std::vector<double> sorted_s(durations_s_.begin(), durations_s_.end());
  const auto middle = sorted_s.begin() + static_cast<std::ptrdiff_t>((sorted_s.size() - 1) / 2);
  std::nth_element(sorted_s.begin(), middle, sorted_s.end());
  return *middle;
}

UncertainPose SteadyMotion::unknown(const Pose2& motion) const
{
  return {motion, unknownMotionCovariance(options_)};
}
}  // namespace psmks
