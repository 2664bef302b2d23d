/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/logs/CarmenReader.h>
#include <psmks/logs/RawlogWriter.h>
#include <psmks/mrpt/Convert.h>

#include <cmath>
#include <utility>

namespace psmks
{
using mrpt::obs::CObservation2DRangeScan;

namespace
{
std::string inLine(const CarmenFinding& finding)
{
  return (finding.times > 1 ? ", the first in line " : ", in line ") +
         std::to_string(finding.firstLine);
}

std::string counted(int count, const std::string& thing)
{
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

/** Converts a message to a scan. An infinite range is no return, also without a maximum range. */
Scan toScan(const CarmenMessage& message, CarmenGeometry& geometry)
{
  const CarmenScanner stated = message.scanner.value_or(CarmenScanner());
  Scan scan;
  scan.grid = geometry.grid(stated, static_cast<int>(message.ranges_m.size()));
  scan.range_m = message.ranges_m;
  for (const double range_m : message.ranges_m) scan.valid.push_back(std::isfinite(range_m));
  scan.maxRange_m = geometry.maxRange_m(stated);
  scan.rangeSigma_m = stated.sigma_m.value_or(0);
  return scan;
}

void remarkOnStamps(const CarmenStampSurvey& stamps, std::vector<std::string>& remarks)
{
  if (stamps.repeated.times > 0)
    remarks.push_back(counted(stamps.repeated.times, "scan") +
                      " with the stamp of the scan before" + inLine(stamps.repeated));
  if (stamps.backwards.times > 0)
    remarks.push_back(counted(stamps.backwards.times, "scan") +
                      " with an earlier stamp than the scan before" + inLine(stamps.backwards) +
                      "; the order is that of the file");
}
}  // namespace

CarmenReader::CarmenReader(const std::string& path, std::optional<std::string> sensorLabel,
                           const CarmenOptions& options)
    : survey_(surveyCarmenLog(path)),
      lines_(path),
      sensorLabel_(std::move(sensorLabel)),
      damage_(damageAtStart())
{
  if (!sensorLabel_ || !isRawLaser(*sensorLabel_)) survey_.leaveOutRepetitions();
  if (!sensorLabel_ && !survey_.sensors.empty()) sensorLabel_ = survey_.firstSensor;
  const std::string sensor = sensorLabel_.value_or("");
  stamp_ = survey_.stampOf(sensor, options.stamp);
  odometry_ = survey_.odometryOf(sensor);
  for (const auto& [label, scans] : survey_.sensors)
    geometries_.emplace(label, CarmenGeometry(label, survey_, options));
}

std::string CarmenReader::damageAtStart() const
{
  if (!survey_.exists) return "no such file, or not to be read";
  if (survey_.lines == 0) return survey_.error.empty() ? "the file is empty" : survey_.error;
  if (survey_.messages > survey_.malformed.times) return "";
  if (!survey_.error.empty()) return survey_.error;
  if (survey_.messages > 0)
    return "none of its " + counted(survey_.messages, "message") + " can be read" +
           inLine(survey_.malformed);
  return "not a CARMEN log: none of its " + counted(survey_.lines, "line") +
         " is a scan (FLASER, ROBOTLASER1, ...) or an odometry (ODOM)";
}

bool CarmenReader::next(LaserFrame& frame)
{
  if (!damage_.empty()) return false;
  for (std::string_view line; lines_.next(line);)
  {
    parseCarmenMessage(line, message_);
    if (take(frame)) return true;
  }
  if (!lines_.error().empty())
    damage_ = "read " + std::to_string(entriesRead_) + " messages, then: " + lines_.error();
  return false;
}

/** Adds a message to the present frame.
 *  @return whether the message completed the frame */
bool CarmenReader::take(LaserFrame& frame)
{
  if (message_.kind == CarmenKind::Other || message_.kind == CarmenKind::Malformed) return false;
  ++entriesRead_;
  if (message_.kind == CarmenKind::Odometry) takeOdometry();
  return message_.kind == CarmenKind::Scan && survey_.sensors.count(message_.name) > 0 &&
         takeScan(frame);
}

void CarmenReader::takeOdometry()
{
  T_odom_read_ = message_.T_odom_robot;
  if (const auto stamp_s = statedStamp_s()) track_.add(*stamp_s, message_.T_odom_robot);
}

bool CarmenReader::takeScan(LaserFrame& frame)
{
  const bool isWanted = message_.name == *sensorLabel_;
  const auto stated_s = statedStamp_s();
  const double stamp_s = stated_s.value_or(lastStamp_s_ + kAssumedPeriod_s);
  const auto scan = observation(stamp_s);
  if (!stated_s) scan->timestamp = INVALID_TIMESTAMP;
  ++scansOfSensors_[message_.name];
  observations_.insert(scan);
  if (!isWanted) return false;

  if (!stated_s) ++stampsMadeUp_;
  frame = LaserFrame();
  frame.scan = scan;
  frame.stamp_s = stamp_s;
  frame.odometry = odometryUntil(stamp_s);
  if (stated_s) frame.beam = CarmenGeometry::beam(message_.scanner);
  frame.observations = observations_;
  observations_.clear();
  lastStamp_s_ = stamp_s;
  return true;
}

CObservation2DRangeScan::Ptr CarmenReader::observation(double stamp_s)
{
  CarmenGeometry& geometry = geometries_.at(message_.name);
  Scan scan = toScan(message_, geometry);
  scan.stamp_s = stamp_s;
  const auto observation = toMrpt(scan, geometry.T_robot_sensor());
  observation->sensorLabel = message_.name;
  return observation;
}

std::optional<double> CarmenReader::statedStamp_s() const
{
  if (!stamp_) return std::nullopt;
  return *stamp_ == CarmenStamp::Ipc ? message_.ipcStamp_s : message_.loggerStamp_s;
}

std::optional<Pose2> CarmenReader::odometryUntil(double stamp_s)
{
  const auto before = std::exchange(T_odom_last_, odometryAt(stamp_s));
  if (!before || !T_odom_last_) return std::nullopt;
  return before->inverse() * *T_odom_last_;
}

std::optional<Pose2> CarmenReader::odometryAt(double stamp_s) const
{
  if (odometry_ == CarmenOdometry::None) return std::nullopt;
  if (odometry_ == CarmenOdometry::Scans) return message_.T_odom_robot;
  const auto T_odom_robot = stamp_ ? track_.poseAt(stamp_s) : std::nullopt;
  return T_odom_robot ? T_odom_robot : T_odom_read_;
}

std::vector<std::string> CarmenReader::remarks() const
{
  std::vector<std::string> remarks;
  if (survey_.malformed.times > 0)
    remarks.push_back(counted(survey_.malformed.times, "malformed message") + " skipped" +
                      inLine(survey_.malformed));
  const auto found = survey_.sensors.find(sensorLabel_.value_or(""));
  if (found == survey_.sensors.end()) return remarks;

  const CarmenSensorSurvey& scans = found->second;
  if (stamp_) remarkOnStamps(*stamp_ == CarmenStamp::Ipc ? scans.ipc : scans.logger, remarks);
  if (odometry_ == CarmenOdometry::OdometryMessages && !isRawLaser(found->first))
    remarks.push_back(
        "the odometry of the scans is zero throughout, that of the ODOM messages "
        "stands in");
  if (scans.mountingVaries && found->first.rfind("ROBOTLASER", 0) == 0)
    remarks.push_back(
        "the messages put the laser to different places on the robot, the "
        "parameters count");
  if (geometries_.at(found->first).isGuessed(scans.scanner, scans.rays))
    remarks.push_back("nothing states the field of view of " + std::to_string(scans.rays) +
                      " rays, 180 degrees are assumed");
  return remarks;
}
}  // namespace psmks
