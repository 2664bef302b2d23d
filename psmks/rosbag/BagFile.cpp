/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <nav_msgs/Odometry.h>
#include <psmks/rosbag/BagFile.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_msgs/TFMessage.h>

#include <cmath>
#include <map>
#include <utility>

namespace psmks
{
namespace
{
using Types = std::vector<std::string>;

const Types kScanTypes{"sensor_msgs/LaserScan"};
const Types kOdometryTypes{"nav_msgs/Odometry"};
const Types kTransformTypes{"tf2_msgs/TFMessage", "tf/tfMessage"};

std::string withoutSlash(const std::string& frame)
{
  return !frame.empty() && frame.front() == '/' ? frame.substr(1) : frame;
}

/** The time of a message, or where it has none the time at which it was recorded. */
double stampOf(const std_msgs::Header& header, const ros::Time& recorded)
{
  return header.stamp.isZero() ? recorded.toSec() : header.stamp.toSec();
}

Eigen::Quaterniond rotationOf(const geometry_msgs::Quaternion& q)
{
  const Eigen::Quaterniond rotation(q.w, q.x, q.y, q.z);
  return rotation.norm() > 0 ? rotation.normalized() : Eigen::Quaterniond::Identity();
}

BagScan toBagScan(const sensor_msgs::LaserScan& message, const ros::Time& recorded)
{
  BagScan scan;
  scan.stamp_s = stampOf(message.header, recorded);
  scan.frame = withoutSlash(message.header.frame_id);
  scan.firstAngle_rad = static_cast<double>(message.angle_min);
  scan.increment_rad = static_cast<double>(message.angle_increment);
  scan.timeIncrement_s = static_cast<double>(message.time_increment);
  scan.minRange_m = static_cast<double>(message.range_min);
  scan.maxRange_m = static_cast<double>(message.range_max);
  scan.range_m = message.ranges;
  return scan;
}

BagOdometry toBagOdometry(const nav_msgs::Odometry& message, const ros::Time& recorded)
{
  const auto& pose = message.pose.pose;
  const Eigen::Matrix3d R = rotationOf(pose.orientation).toRotationMatrix();
  return {stampOf(message.header, recorded),
          withoutSlash(message.child_frame_id),
          {pose.position.x, pose.position.y, std::atan2(R(1, 0), R(0, 0))}};
}

BagTransform toBagTransform(const geometry_msgs::TransformStamped& message,
                            const ros::Time& recorded)
{
  const auto& t = message.transform.translation;
  BagTransform transform;
  transform.stamp_s = stampOf(message.header, recorded);
  transform.parent = withoutSlash(message.header.frame_id);
  transform.child = withoutSlash(message.child_frame_id);
  transform.T_parent_child =
      Eigen::Translation3d(t.x, t.y, t.z) * rotationOf(message.transform.rotation);
  return transform;
}

/** What the library says, without the names of its classes. */
std::string readableError(const std::exception& error)
{
  if (dynamic_cast<const rosbag::BagUnindexedException*>(&error))
    return "the bag has no index, as after a recording that broke off: rosbag reindex makes one";
  if (dynamic_cast<const rosbag::BagIOException*>(&error)) return "the bag ends within a record";
  return "the bag cannot be decoded (" + std::string(error.what()) + ")";
}
}  // namespace

struct BagFile::Content
{
  rosbag::Bag bag;
  rosbag::View scans;
  rosbag::View::iterator nextScan;

  std::vector<BagTopic> topicsOf(const Types& types)
  {
    rosbag::View view(bag, rosbag::TypeQuery(types));
    std::map<std::string, std::size_t> messages;
    for (const rosbag::ConnectionInfo* connection : view.getConnections())
      messages[connection->topic] = 0;
    std::vector<BagTopic> topics;
    for (const auto& [topic, none] : messages)
    {
      rosbag::View ofTopic(bag, rosbag::TopicQuery(topic));
      topics.push_back({topic, ofTopic.size()});
    }
    return topics;
  }
};

BagFile::BagFile(const std::string& path) : content_(std::make_unique<Content>())
{
  try
  {
    content_->bag.open(path, rosbag::bagmode::Read);
    scanTopics_ = content_->topicsOf(kScanTypes);
    odometryTopics_ = content_->topicsOf(kOdometryTypes);
  }
  catch (const std::exception& error)
  {
    error_ = readableError(error);
    content_.reset();
  }
}

BagFile::~BagFile() = default;

void BagFile::forEachOdometry(const std::string& topic,
                              const std::function<void(const BagOdometry&)>& use)
{
  if (!content_) return;
  try
  {
    rosbag::View view(content_->bag, rosbag::TopicQuery(topic));
    for (const rosbag::MessageInstance& message : view)
      if (const auto odometry = message.instantiate<nav_msgs::Odometry>())
        use(toBagOdometry(*odometry, message.getTime()));
  }
  catch (const std::exception& error)
  {
    error_ = readableError(error);
  }
}

void BagFile::forEachTransform(const std::function<void(const BagTransform&)>& use)
{
  if (!content_) return;
  try
  {
    rosbag::View view(content_->bag, rosbag::TypeQuery(kTransformTypes));
    for (const rosbag::MessageInstance& message : view)
      if (const auto transforms = message.instantiate<tf2_msgs::TFMessage>())
        for (const auto& transform : transforms->transforms)
          use(toBagTransform(transform, message.getTime()));
  }
  catch (const std::exception& error)
  {
    error_ = readableError(error);
  }
}

void BagFile::openScans(const std::string& topic)
{
  if (!content_) return;
  try
  {
    content_->scans.addQuery(content_->bag, rosbag::TopicQuery(topic));
    content_->nextScan = content_->scans.begin();
  }
  catch (const std::exception& error)
  {
    error_ = readableError(error);
    content_.reset();
  }
}

bool BagFile::nextScan(BagScan& scan)
{
  if (!content_) return false;
  try
  {
    for (auto& next = content_->nextScan; next != content_->scans.end();)
    {
      const auto message = next->instantiate<sensor_msgs::LaserScan>();
      const ros::Time recorded = next->getTime();
      ++next;
      if (!message) continue;
      scan = toBagScan(*message, recorded);
      return true;
    }
  }
  catch (const std::exception& error)
  {
    error_ = readableError(error);
    content_.reset();
  }
  return false;
}
}  // namespace psmks
