/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/rosbag/FrameTree.h>

#include <cmath>

namespace psmks
{
namespace
{
/** A change of a transform by more than rounding. Unit: m, and of the entries of its rotation.
 * Definition: below what any robot moves. */
constexpr double kChange = 1e-4;

Pose2 planar(const Eigen::Isometry3d& T)
{
  return {T.translation().x(), T.translation().y(), std::atan2(T(1, 0), T(0, 0))};
}
}  // namespace

void FrameTree::add(const BagTransform& transform)
{
  const auto [entry, isNew] = edges_.try_emplace(transform.child);
  Edge& edge = entry->second;
  if (isNew)
  {
    edge.parent = transform.parent;
    edge.first = transform.T_parent_child;
  }
  const Eigen::Matrix4d change = transform.T_parent_child.matrix() - edge.first.matrix();
  edge.moves = edge.moves || change.cwiseAbs().maxCoeff() > kChange;
  edge.readings.push_back({transform.stamp_s, planar(transform.T_parent_child)});
}

std::string FrameTree::robotOf(const std::string& sensorFrame) const
{
  std::string named = sensorFrame, frame = sensorFrame;
  for (std::size_t up = 0; up <= edges_.size(); ++up)
  {
    if (frame == "base_link" || frame == "base_footprint") named = frame;
    const auto edge = edges_.find(frame);
    if (edge == edges_.end()) break;
    if (edge->second.moves) return frame;
    frame = edge->second.parent;
  }
  return named;
}

std::optional<Eigen::Isometry3d> FrameTree::poseOf(const std::string& frame,
                                                   const std::string& above) const
{
  Eigen::Isometry3d T_here_frame = Eigen::Isometry3d::Identity();
  std::string here = frame;
  for (std::size_t up = 0; up <= edges_.size(); ++up)
  {
    if (here == above) return T_here_frame;
    const auto edge = edges_.find(here);
    if (edge == edges_.end()) break;
    T_here_frame = edge->second.first * T_here_frame;
    here = edge->second.parent;
  }
  return std::nullopt;
}

std::vector<FrameTree::Reading> FrameTree::motionOf(const std::string& frame) const
{
  const auto edge = edges_.find(frame);
  if (edge == edges_.end() || !edge->second.moves) return {};
  return edge->second.readings;
}
}  // namespace psmks
