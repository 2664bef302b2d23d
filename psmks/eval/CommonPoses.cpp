/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/eval/CommonPoses.h>
#include <psmks/eval/Interpolation.h>
#include <psmks/eval/StampIndex.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace psmks
{
namespace
{
std::vector<CommonPose> commonByStamp(const Trajectory& estimate, const Trajectory& truth)
{
  /** The truth is as dense as the estimate if its steps are at most this many times as long. The
   * margin allows for stamps that jitter. */
  constexpr double kAsDense = 1.5;
  std::vector<CommonPose> common;
  double last_s = -std::numeric_limits<double>::infinity();
  for (const auto& [stamp_s, pose] : estimate)
  {
    const double step_s = stamp_s - std::exchange(last_s, stamp_s);
    const auto bracket = bracketAt(truth, stamp_s);
    if (!bracket) continue;
    const bool isMeasured = bracket->nearest_s(stamp_s) <= kStampTolerance_s ||
                            bracket->gap_s() < kAsDense * std::abs(step_s);
    common.push_back({stamp_s, pose, bracket->poseAt(stamp_s), isMeasured});
  }
  return common;
}

std::vector<CommonPose> commonByNumber(const Trajectory& estimate, const Trajectory& truth)
{
  const std::size_t first = estimate.size() == truth.size() + 1 ? 1 : 0;
  if (estimate.size() != truth.size() + first) return {};
  std::vector<CommonPose> common;
  for (std::size_t i = 0; i < truth.size(); ++i)
  {
    const auto& [stamp_s, pose] = estimate[first + i];
    common.push_back({stamp_s, pose, truth[i].pose, true});
  }
  return common;
}

/** Whether the stamps of the estimate lie outside the numbers of the rows, so that they are times.
 */
bool hasTimesBeyond(const Trajectory& estimate, const Trajectory& numbered)
{
  return std::all_of(estimate.begin(), estimate.end(),
                     [&numbered](const StampedPose& p)
                     { return p.stamp_s < 0 || p.stamp_s > numbered.back().stamp_s; });
}
}  // namespace

std::vector<CommonPose> commonPoses(const Trajectory& estimate, const Trajectory& truth)
{
  if (isNumbered(truth) && hasTimesBeyond(estimate, truth)) return commonByNumber(estimate, truth);
  return commonByStamp(estimate, truth);
}

bool isNumbered(const Trajectory& trajectory)
{
  double number = 0;
  return !trajectory.empty() &&
         std::all_of(trajectory.begin(), trajectory.end(),
                     [&number](const StampedPose& p) { return p.stamp_s == number++; });
}
}  // namespace psmks
