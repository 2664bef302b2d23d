/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <mrpt/core/Clock.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/poses/CPose3D.h>
#include <psmks/logs/RawlogReader.h>
#include <psmks/mrpt/Convert.h>

#include <cmath>
#include <utility>

namespace psmks
{
using mrpt::obs::CActionCollection;
using mrpt::obs::CActionRobotMovement2D;
using mrpt::obs::CObservation;
using mrpt::obs::CObservation2DRangeScan;
using mrpt::obs::CObservationOdometry;
using mrpt::obs::CSensoryFrame;
using mrpt::serialization::CSerializable;

namespace
{
/** The motion measured by odometry, if the actions have one; other estimates of the motion are
 * ignored. */
std::optional<Pose2> motionOf(const CActionCollection& actions)
{
  for (const auto& action : actions)
  {
    if (!action.get()) return std::nullopt;  // damaged
    const auto* motion = dynamic_cast<const CActionRobotMovement2D*>(action.get());
    if (motion && motion->estimationMethod == CActionRobotMovement2D::emOdometry)
      return toPose2(motion->rawOdometryIncrementReading);
  }
  mrpt::poses::CPose3D mean;
  if (!actions.getFirstMovementEstimationMean(mean)) return std::nullopt;
  return toPose2(mrpt::poses::CPose2D(mean));
}

/** Whether a robot can have a scanner there. */
bool isMounting(const mrpt::poses::CPose3D& pose)
{
  /** Largest offset of a scanner. Definition: a ship. */
  constexpr double kLargest_m = 100;
  const bool isFinite = std::isfinite(pose.yaw()) && std::isfinite(pose.pitch()) &&
                        std::isfinite(pose.roll()) && std::isfinite(pose.norm());
  return isFinite && pose.norm() < kLargest_m;
}

/** Whether a robot can have moved so between two scans. */
bool isMotion(const Pose2& motion)
{
  /** Farthest motion. Definition: half way round the Earth. */
  constexpr double kFarthest_m = 2e7;
  return motion.isFinite() && motion.translation().norm() < kFarthest_m;
}

std::string countedThings(int count, const std::string& thing, const std::string& things)
{
  return std::to_string(count) + ' ' + (count == 1 ? thing : things);
}

mrpt::Clock::time_point timeOf(const CActionCollection& actions)
{
  for (const auto& action : actions)
    if (action.get() && action->timestamp != INVALID_TIMESTAMP) return action->timestamp;
  return INVALID_TIMESTAMP;
}
}  // namespace

RawlogReader::RawlogReader(const std::string& path, std::optional<std::string> sensorLabel)
    : entries_(path), sensorLabel_(std::move(sensorLabel))
{
}

bool RawlogReader::next(LaserFrame& frame)
{
  while (frames_.empty())
  {
    const auto entry = entries_.next();
    if (!entry) return false;
    take(entry);
  }
  frame = std::move(frames_.front());
  frames_.pop_front();
  return true;
}

std::vector<std::string> RawlogReader::remarks() const
{
  std::vector<std::string> remarks;
  if (absurdScans_ > 0)
    remarks.push_back(countedThings(absurdScans_, "scan", "scans") +
                      " left out, for the scanner would not be on a robot");
  if (absurdMotions_ > 0)
    remarks.push_back(countedThings(absurdMotions_, "motion", "motions") +
                      " of the odometry left out, for no robot moves so far");
  return remarks;
}

void RawlogReader::take(const CSerializable::Ptr& entry)
{
  if (const auto actions = std::dynamic_pointer_cast<CActionCollection>(entry))
    takeActions(*actions);
  else if (const auto frame = std::dynamic_pointer_cast<CSensoryFrame>(entry))
    takeSensoryFrame(*frame);
  else if (const auto observation = std::dynamic_pointer_cast<CObservation>(entry))
  {
    takeOdometry(*observation);
    takeObservation(observation);
  }
}

void RawlogReader::takeActions(const CActionCollection& actions)
{
  actionTime_ = timeOf(actions);
  if (const auto motion = motionOf(actions)) motion_.addIncrement(*motion);
}

void RawlogReader::takeSensoryFrame(const CSensoryFrame& frame)
{
  for (const auto& observation : frame)
    if (observation) takeOdometry(*observation);
  for (const auto& observation : frame)
    if (observation) takeObservation(observation);
}

void RawlogReader::takeOdometry(const CObservation& observation)
{
  const auto* odometry = dynamic_cast<const CObservationOdometry*>(&observation);
  if (!odometry) return;
  const bool stamped = odometry->timestamp != INVALID_TIMESTAMP;
  motion_.addReading(stamped ? mrpt::Clock::toDouble(odometry->timestamp) : lastStamp_s_,
                     toPose2(odometry->odometry));
}

void RawlogReader::takeObservation(const CObservation::Ptr& observation)
{
  if (std::dynamic_pointer_cast<CObservationOdometry>(observation)) return;
  const auto scan = std::dynamic_pointer_cast<CObservation2DRangeScan>(observation);
  if (scan && !isMounting(scan->sensorPose))
  {
    ++absurdScans_;
    return;
  }
  observations_.insert(observation);
  if (!scan) return;
  ++scansOfSensors_[scan->sensorLabel];
  if (!sensorLabel_) sensorLabel_ = scan->sensorLabel;
  if (scan->sensorLabel == *sensorLabel_) finishFrame(scan);
}

void RawlogReader::finishFrame(const CObservation2DRangeScan::Ptr& scan)
{
  LaserFrame frame;
  frame.scan = scan;
  frame.stamp_s = stampOf(*scan);
  frame.odometry = motion_.untilScan(frame.stamp_s);
  if (frame.odometry && !isMotion(*frame.odometry))
  {
    frame.odometry.reset();
    ++absurdMotions_;
  }
  frame.observations = observations_;
  frames_.push_back(std::move(frame));
  observations_.clear();
  lastStamp_s_ = frames_.back().stamp_s;
}

double RawlogReader::stampOf(const CObservation& observation)
{
  if (observation.timestamp != INVALID_TIMESTAMP)
    return mrpt::Clock::toDouble(observation.timestamp);
  if (actionTime_ != INVALID_TIMESTAMP) return mrpt::Clock::toDouble(actionTime_);
  ++stampsMadeUp_;
  return lastStamp_s_ + kAssumedPeriod_s;
}
}  // namespace psmks
