/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/slam/OnlineSlam.h>

#include <optional>
#include <utility>

namespace psmks
{
namespace
{
PoseSource sourceOf(const PosedScan& scan, bool isFirst, bool hasOdometry)
{
  if (isFirst) return PoseSource::FirstScan;
  if (scan.isMatched()) return PoseSource::Match;
  return hasOdometry ? PoseSource::Odometry : PoseSource::ConstantVelocity;
}
}  // namespace

const char* toString(PoseSource source)
{
  switch (source)
  {
    case PoseSource::FirstScan:
      return "FirstScan";
    case PoseSource::Match:
      return "Match";
    case PoseSource::Odometry:
      return "Odometry";
    case PoseSource::ConstantVelocity:
      return "ConstantVelocity";
  }
  return "?";
}

OnlineSlam::OnlineSlam(const OnlineSlamOptions& options)
    : builder_(makePairMatcher("psmks", options.matcher), options.reference, options.odometry)
{
}

void OnlineSlam::addOdometry(double stamp_s, const Pose2& T_odom_robot)
{
  motion_.addReading(stamp_s, T_odom_robot);
}

void OnlineSlam::addMotion(const Pose2& T_before_after) { motion_.addIncrement(T_before_after); }

OnlinePose OnlineSlam::addScan(Scan scan, const Pose2& T_robot_sensor)
{
  const bool isFirst = builder_.scans().empty();
  const std::optional<Pose2> odometry = motion_.untilScan(scan.stamp_s);
  const PosedScan& posed = builder_.add(std::move(scan), T_robot_sensor, odometry);

  OnlinePose pose;
  pose.stamp_s = posed.stamp_s();
  pose.T_world_robot = posed.T_world_robot;
  pose.source = sourceOf(posed, isFirst, odometry.has_value());
  if (const ReferenceMatch* match = posed.decidingMatch()) pose.match = match->result;
  if (listener_) listener_(pose);
  return pose;
}

void OnlineSlam::setListener(Listener listener) { listener_ = std::move(listener); }

void OnlineSlam::optimise() { builder_.optimise(); }
}  // namespace psmks
