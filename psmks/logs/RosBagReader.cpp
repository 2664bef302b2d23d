/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <mrpt/core/Clock.h>
#include <psmks/geometry/Angle.h>
#include <psmks/logs/RosBagReader.h>
#include <psmks/mrpt/Convert.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace psmks
{
namespace
{
/** The topic with most messages; null where there is none. */
const BagTopic* busiest(const std::vector<BagTopic>& topics)
{
  const auto most = std::max_element(topics.begin(), topics.end(),
                                     [](const BagTopic& a, const BagTopic& b)
                                     { return a.messages < b.messages; });
  return most == topics.end() ? nullptr : &*most;
}

std::string listed(const std::vector<BagTopic>& topics)
{
  std::string text;
  for (const BagTopic& topic : topics)
    text += (text.empty() ? "'" : ", '") + topic.name + "' (" + std::to_string(topic.messages) +
            " messages)";
  return text;
}

/** A topic by its name, which may lack its first slash. */
const BagTopic* named(const std::vector<BagTopic>& topics, const std::string& name)
{
  for (const BagTopic& topic : topics)
    if (topic.name == name || topic.name == "/" + name) return &topic;
  return nullptr;
}

mrpt::poses::CPose3D toMrpt(const Eigen::Isometry3d& T)
{
  mrpt::math::CMatrixDouble44 matrix;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) matrix(row, column) = T(row, column);
  return mrpt::poses::CPose3D(matrix);
}
}  // namespace

RosBagReader::RosBagReader(const std::string& path, const std::optional<std::string>& sensorLabel,
                           const RosBagOptions& options)
    : bag_(path), options_(options), sensorLabel_(sensorLabel)
{
  for (const BagTopic& topic : bag_.scanTopics())
    scansOfSensors_[topic.name] = static_cast<int>(topic.messages);
  const BagTopic* topic =
      sensorLabel_ ? named(bag_.scanTopics(), *sensorLabel_) : busiest(bag_.scanTopics());
  damage_ = bag_.error();
  if (!topic || !damage_.empty()) return;
  sensorLabel_ = topic->name;
  begin();
  damage_ = bag_.error();
}

/** Reads what has to be known before the first scan is returned. */
void RosBagReader::begin()
{
  bag_.openScans(*sensorLabel_);
  BagScan first;
  if (!bag_.nextScan(first)) return;
  ahead_ = first;
  bag_.forEachTransform([this](const BagTransform& transform) { frames_.add(transform); });
  robotFrame_ = frames_.robotOf(first.frame);
  readOdometry();
  placeSensor();
}

void RosBagReader::readOdometry()
{
  const auto& topics = bag_.odometryTopics();
  const BagTopic* topic =
      options_.odometryTopic ? named(topics, *options_.odometryTopic) : busiest(topics);
  if (options_.odometryTopic && !topic)
    remarks_.push_back("holds no odometry of the topic '" + *options_.odometryTopic + "'" +
                       (topics.empty() ? "" : ", but of " + listed(topics)));
  if (!topic)
  {
    odometry_ = frames_.motionOf(robotFrame_);
    return;
  }
  if (topics.size() > 1 && !options_.odometryTopic)
    remarks_.push_back("took the odometry of '" + topic->name + "' of " + listed(topics) +
                       ", --bag-odometry chooses another");
  bag_.forEachOdometry(topic->name,
                       [this](const BagOdometry& odometry)
                       {
                         odometry_.push_back({odometry.stamp_s, odometry.T_odom_robot});
                         if (!odometry.robotFrame.empty()) robotFrame_ = odometry.robotFrame;
                       });
}

/** Finds where the sensor sits on the robot. */
void RosBagReader::placeSensor()
{
  if (options_.T_robot_sensor)
  {
    T_robot_sensor_ = mrpt::poses::CPose3D(psmks::toMrpt(*options_.T_robot_sensor));
    return;
  }
  if (const auto T = frames_.poseOf(ahead_->frame, robotFrame_))
    T_robot_sensor_ = toMrpt(*T);
  else if (!odometry_.empty())
    remarks_.push_back("no transform tells where '" + ahead_->frame + "' sits on '" + robotFrame_ +
                       "': taken for its origin, --bag-sensor-pose states it");
}

bool RosBagReader::next(LaserFrame& frame)
{
  BagScan scan;
  if (ahead_)
    scan = *std::exchange(ahead_, std::nullopt);
  else if (!damage_.empty() || !bag_.nextScan(scan))
  {
    if (damage_.empty() && !bag_.error().empty())
      damage_ = "read " + std::to_string(scansRead_) + " scans, then: " + bag_.error();
    return false;
  }
  ++scansRead_;
  frame = LaserFrame();
  frame.scan = observation(scan);
  frame.stamp_s = scan.stamp_s;
  frame.odometry = motionUntil(scan.stamp_s);
  frame.beam.turn_s = 2 * kPi / std::abs(scan.increment_rad) * scan.timeIncrement_s;
  frame.observations.insert(frame.scan);
  return true;
}

/** The motion of the robot since the last scan of which the odometry tells the pose. */
std::optional<Pose2> RosBagReader::motionUntil(double stamp_s)
{
  while (nextReading_ < odometry_.size())
  {
    const FrameTree::Reading& reading = odometry_[nextReading_];
    track_.add(reading.stamp_s, reading.T_parent_child);
    ++nextReading_;
    if (reading.stamp_s >= stamp_s) break;
  }
  const auto T_odom_robot = track_.poseAt(stamp_s);
  if (!T_odom_robot) return std::nullopt;
  const auto T_odom_last = std::exchange(T_odom_last_, T_odom_robot);
  if (!T_odom_last) return std::nullopt;
  return T_odom_last->inverse() * *T_odom_robot;
}

/** A scan as MRPT describes it: its x axis is the middle of the rays. */
mrpt::obs::CObservation2DRangeScan::Ptr RosBagReader::observation(const BagScan& scan) const
{
  const auto rays = scan.range_m.size();
  const double span_rad = scan.increment_rad * (static_cast<double>(rays) - 1);
  auto observation = mrpt::obs::CObservation2DRangeScan::Create();
  observation->timestamp = mrpt::Clock::fromDouble(scan.stamp_s);
  observation->sensorLabel = *sensorLabel_;
  observation->aperture = static_cast<float>(std::abs(span_rad));
  observation->rightToLeft = scan.increment_rad > 0;
  observation->maxRange = static_cast<float>(scan.maxRange_m);
  observation->sensorPose =
      T_robot_sensor_ + mrpt::poses::CPose3D(0, 0, 0, scan.firstAngle_rad + span_rad / 2, 0, 0);
  observation->resizeScan(rays);
  for (std::size_t ray = 0; ray < rays; ++ray)
  {
    const double range_m = static_cast<double>(scan.range_m[ray]);
    const bool isValid =
        std::isfinite(range_m) && range_m >= scan.minRange_m && range_m <= scan.maxRange_m;
    observation->setScanRange(ray, scan.range_m[ray]);
    observation->setScanRangeValidity(ray, isValid);
  }
  return observation;
}

double RosBagReader::shareRead() const
{
  const auto scans = sensorLabel_ ? scansOfSensors_.find(*sensorLabel_) : scansOfSensors_.end();
  if (scans == scansOfSensors_.end() || scans->second == 0) return 1;
  return std::min(1.0, static_cast<double>(scansRead_) / scans->second);
}
}  // namespace psmks
