/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/motion/MotionBetweenScans.h>
#include <psmks/slam/OnlineSlam.h>
#include <psmks/slam/TrajectoryBuilder.h>

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

struct OnlineSlam::State
{
  explicit State(const OnlineSlamOptions& options)
      : builder(makePairMatcher("psmks", options.matcher), options.reference, options.odometry)
  {
  }

  TrajectoryBuilder builder;
  MotionBetweenScans motion;
  Listener listener;
};

OnlineSlam::OnlineSlam(const OnlineSlamOptions& options) : state_(std::make_unique<State>(options))
{
}
OnlineSlam::~OnlineSlam() = default;
OnlineSlam::OnlineSlam(OnlineSlam&&) noexcept = default;
OnlineSlam& OnlineSlam::operator=(OnlineSlam&&) noexcept = default;

void OnlineSlam::addOdometry(double stamp_s, const Pose2& T_odom_robot)
{
  state_->motion.addReading(stamp_s, T_odom_robot);
}

void OnlineSlam::addMotion(const Pose2& T_before_after)
{
  state_->motion.addIncrement(T_before_after);
}

OnlinePose OnlineSlam::addScan(Scan scan, const Pose2& T_robot_sensor)
{
  const bool isFirst = state_->builder.scans().empty();
  const std::optional<Pose2> odometry = state_->motion.untilScan(scan.stamp_s);
  const PosedScan& posed = state_->builder.add(std::move(scan), T_robot_sensor, odometry);

  OnlinePose pose;
  pose.stamp_s = posed.stamp_s();
  pose.T_world_robot = posed.T_world_robot;
  pose.source = sourceOf(posed, isFirst, odometry.has_value());
  if (const ReferenceMatch* match = posed.decidingMatch()) pose.match = match->result;
  if (state_->listener) state_->listener(pose);
  return pose;
}

void OnlineSlam::setListener(Listener listener) { state_->listener = std::move(listener); }

void OnlineSlam::optimise() { state_->builder.optimise(); }

const std::vector<PosedScan>& OnlineSlam::scans() const { return state_->builder.scans(); }
}  // namespace psmks
