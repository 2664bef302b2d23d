/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/eval/PathErrors.h>
#include <psmks/geometry/Angle.h>

#include <cmath>

namespace psmks
{
namespace
{
PairError motionError(const CommonPose& from, const CommonPose& to)
{
  return pairError(from.T_estimated.inverse() * to.T_estimated, from.T_true.inverse() * to.T_true);
}

/** Sums of cosines and sines of a rotation; their direction is the least-squares rotation. */
struct RotationSums
{
  double cosines = 0, sines = 0;

  void addTurn(const Eigen::Vector2d& from, const Eigen::Vector2d& to)
  {
    cosines += from.dot(to);
    sines += from.x() * to.y() - from.y() * to.x();
  }
  void addAngle(double angle_rad)
  {
    cosines += std::cos(angle_rad);
    sines += std::sin(angle_rad);
  }
  double strength() const { return std::hypot(cosines, sines); }
  double angle_rad() const { return std::atan2(sines, cosines); }
};

struct Centroids
{
  Eigen::Vector2d estimated = Eigen::Vector2d::Zero(), truth = Eigen::Vector2d::Zero();
};

Centroids centroidsOf(const std::vector<CommonPose>& common)
{
  Centroids sums;
  for (const CommonPose& pose : common)
  {
    sums.estimated += pose.T_estimated.translation();
    sums.truth += pose.T_true.translation();
  }
  const double n = static_cast<double>(common.size());
  return {sums.estimated / n, sums.truth / n};
}

/** The rotation from the frame of the estimate into that of the truth. */
double rotationBetween(const std::vector<CommonPose>& common, const Centroids& centroids)
{
  constexpr double kOpen_m2 = 1e-12;  // sums of squares below it are rounding error: the positions
                                      // then determine no rotation
  RotationSums positions, headings;
  for (const auto& [stamp_s, T_estimated, T_true, isMeasured] : common)
  {
    positions.addTurn(T_estimated.translation() - centroids.estimated,
                      T_true.translation() - centroids.truth);
    const double turn_rad = T_true.phi_rad - T_estimated.phi_rad;
    if (!std::isnan(turn_rad)) headings.addAngle(turn_rad);
  }
  return (positions.strength() > kOpen_m2 ? positions : headings).angle_rad();
}
}  // namespace

Pose2 alignAtFirstPose(const std::vector<CommonPose>& common)
{
  if (common.empty()) return {};
  const CommonPose& first = common.front();
  if (first.hasHeadings()) return first.T_true * first.T_estimated.inverse();
  const Pose2 turned{0, 0, align(common).phi_rad};
  const Eigen::Vector2d shift =
      first.T_true.translation() - turned * first.T_estimated.translation();
  return {shift.x(), shift.y(), turned.phi_rad};
}

// The centroids are laid over each other, and the estimate is turned about them by the angle that
// maximises the sum of a_i' R b_i: atan2(sum b_i x a_i, sum b_i . a_i), with a and b relative to
// the centroids.
Pose2 align(const std::vector<CommonPose>& common)
{
  if (common.empty()) return {};
  const Centroids centroids = centroidsOf(common);
  Pose2 T_truth_estimate{0, 0, rotationBetween(common, centroids)};
  const Eigen::Vector2d shift = centroids.truth - T_truth_estimate * centroids.estimated;
  T_truth_estimate.x_m = shift.x();
  T_truth_estimate.y_m = shift.y();
  return T_truth_estimate;
}

std::vector<PairError> absoluteErrors(const std::vector<CommonPose>& common,
                                      const Pose2& T_truth_estimate)
{
  std::vector<PairError> errors;
  for (const CommonPose& pose : common)
    errors.push_back(pairError(T_truth_estimate * pose.T_estimated, pose.T_true));
  return errors;
}

std::vector<PairError> stepErrors(const std::vector<CommonPose>& common)
{
  std::vector<PairError> errors;
  const CommonPose* last = nullptr;
  for (const CommonPose& pose : common)
  {
    if (!pose.isMeasured || !pose.hasHeadings()) continue;
    if (last) errors.push_back(motionError(*last, pose));
    last = &pose;
  }
  return errors;
}

std::vector<PairError> driftErrors(const std::vector<CommonPose>& common, double length_m)
{
  const std::vector<double> path_m = truePathLengths_m(common);
  std::vector<PairError> errors;
  std::size_t to = 0;
  for (std::size_t from = 0; from < common.size(); ++from)
  {
    while (to < common.size() && path_m[to] - path_m[from] < length_m) ++to;
    if (to == common.size()) break;
    if (!common[from].hasHeadings() || !common[to].hasHeadings()) continue;
    const PairError error = motionError(common[from], common[to]);
    const double scale = length_m / (path_m[to] - path_m[from]);
    errors.push_back({scale * error.translation_m, scale * error.rotation_rad});
  }
  return errors;
}

std::vector<double> truePathLengths_m(const std::vector<CommonPose>& common)
{
  std::vector<double> lengths_m;
  double length_m = 0;
  for (std::size_t i = 0; i < common.size(); ++i)
  {
    const CommonPose& last = common[i > 0 ? i - 1 : 0];
    length_m += (common[i].T_true.translation() - last.T_true.translation()).norm();
    lengths_m.push_back(length_m);
  }
  return lengths_m;
}
}  // namespace psmks
