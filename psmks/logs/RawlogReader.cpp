/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <mrpt/core/Clock.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/poses/CPose3D.h>
#include <mrpt/serialization/CArchive.h>
#include <psmks/logs/RawlogReader.h>
#include <psmks/mrpt/Convert.h>

#include <regex>
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
    const auto* motion = dynamic_cast<const CActionRobotMovement2D*>(action.get());
    if (motion && motion->estimationMethod == CActionRobotMovement2D::emOdometry)
      return toPose2(motion->rawOdometryIncrementReading);
  }
  mrpt::poses::CPose3D mean;
  if (!actions.getFirstMovementEstimationMean(mean)) return std::nullopt;
  return toPose2(mrpt::poses::CPose2D(mean));
}

mrpt::Clock::time_point timeOf(const CActionCollection& actions)
{
  for (const auto& action : actions)
    if (action->timestamp != INVALID_TIMESTAMP) return action->timestamp;
  return INVALID_TIMESTAMP;
}

/** Shortens an error text of MRPT, which contains source lines and addresses, to the name of the
 * missing class. */
std::string readableReason(const std::string& mrptError)
{
  static const std::regex kUnknownClass("class '([A-Za-z0-9_:]+)' which is not registered");
  std::smatch match;
  if (std::regex_search(mrptError, match, kUnknownClass))
    return "is of the unknown class '" + match[1].str() + "'";
  return "cannot be decoded";
}
}  // namespace

RawlogReader::RawlogReader(const std::string& path, std::optional<std::string> sensorLabel)
    : file_(path), sensorLabel_(std::move(sensorLabel))
{
  if (!file_.isOpen())
    damage_ = "no such file, or not to be read";
  else if (file_.isAtEnd())
    damage_ = file_.error().empty() ? "the file is empty" : file_.error();
}

bool RawlogReader::next(LaserFrame& frame)
{
  while (frames_.empty())
    if (!readEntry()) return false;
  frame = std::move(frames_.front());
  frames_.pop_front();
  return true;
}

bool RawlogReader::readEntry()
{
  if (!damage_.empty()) return false;
  if (file_.isAtEnd())
  {
    if (!file_.error().empty()) reportDamage("");
    return false;
  }
  try
  {
    auto archive = mrpt::serialization::archiveFrom(file_);
    const CSerializable::Ptr entry = archive.ReadObject();
    ++entriesRead_;
    take(entry);
    return true;
  }
  catch (const std::exception& error)
  {
    reportDamage(error.what());
    return false;
  }
}

void RawlogReader::reportDamage(const std::string& error)
{
  const std::string entry = "entry " + std::to_string(entriesRead_ + 1);
  const std::string reason = !file_.error().empty() ? file_.error()
                             : file_.isAtEnd()      ? "the file ends within " + entry
                                                    : entry + " " + readableReason(error);
  damage_ = entriesRead_ > 0 ? "read " + std::to_string(entriesRead_) + " entries, then: " + reason
                             : "not an MRPT rawlog: " + reason;
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
  for (const auto& observation : frame) takeOdometry(*observation);
  for (const auto& observation : frame) takeObservation(observation);
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
  observations_.insert(observation);

  const auto scan = std::dynamic_pointer_cast<CObservation2DRangeScan>(observation);
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
