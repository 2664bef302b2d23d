/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/gzip/GzipLines.h>
#include <psmks/logs/CarmenSurvey.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace psmks
{
namespace
{
/** Mountings that differ by less are the same: poses in logs have few digits. */
constexpr double kMountingTolerance_m = 0.01, kMountingTolerance_rad = 0.01;

bool isZero(const Pose2& pose) { return pose.x_m == 0 && pose.y_m == 0 && pose.phi_rad == 0; }

bool isAnotherMounting(const Pose2& difference)
{
  return difference.translation().norm() > kMountingTolerance_m ||
         std::abs(difference.phi_rad) > kMountingTolerance_rad;
}

void add(const CarmenMessage& message, int line, CarmenSurvey& survey)
{
  switch (message.kind)
  {
    case CarmenKind::Scan:
      if (survey.sensors.empty()) survey.firstSensor = message.name;
      survey.sensors[message.name].add(message, line);
      break;
    case CarmenKind::Odometry:
      survey.odometryMoves |= !isZero(message.T_odom_robot);
      break;
    case CarmenKind::Parameter:
      survey.parameters[message.name] = message.value;
      break;
    case CarmenKind::Malformed:
      survey.malformed.add(line);
      break;
    case CarmenKind::Other:
      return;
  }
  ++survey.messages;
}
}  // namespace

void CarmenStampSurvey::add(double stamp_s, int line)
{
  if (stamps++ > 0)
  {
    changes |= stamp_s != last_s;
    if (stamp_s == last_s) repeated.add(line);
    if (stamp_s < last_s) backwards.add(line);
  }
  isAboveZero |= stamp_s > 0;
  last_s = stamp_s;
}

void CarmenSensorSurvey::add(const CarmenMessage& message, int line)
{
  const Pose2 mounting = message.T_odom_robot.inverse() * message.T_odom_laser;
  if (scans++ == 0)
  {
    rays = static_cast<int>(message.ranges_m.size());
    T_robot_sensor = mounting;
    scanner = message.scanner.value_or(CarmenScanner());
  }
  mountingVaries |= isAnotherMounting(T_robot_sensor.inverse() * mounting);
  odometryIsZero &= isZero(message.T_odom_robot);
  ipc.add(message.ipcStamp_s, line);
  logger.add(message.loggerStamp_s, line);
  for (const double range_m : message.ranges_m) noReturn.add(range_m);
}

std::optional<CarmenStamp> CarmenSurvey::stampOf(const std::string& sensor,
                                                 const std::optional<CarmenStamp>& wanted) const
{
  const auto found = sensors.find(sensor);
  if (found == sensors.end()) return std::nullopt;
  const bool ipc = found->second.ipc.isMeaningful(), logger = found->second.logger.isMeaningful();
  if (ipc && wanted != CarmenStamp::Logger) return CarmenStamp::Ipc;
  if (logger && wanted != CarmenStamp::Ipc) return CarmenStamp::Logger;
  return std::nullopt;
}

void CarmenSurvey::leaveOutRepetitions()
{
  int mostPosed = 0;
  for (const auto& [name, sensor] : sensors)
    if (!isRawLaser(name)) mostPosed = std::max(mostPosed, sensor.scans);
  for (auto it = sensors.begin(); it != sensors.end();)
  {
    const bool isRepetition = isRawLaser(it->first) && 2 * mostPosed >= it->second.scans;
    it = isRepetition ? sensors.erase(it) : std::next(it);
  }
  if (sensors.count(firstSensor) == 0 && !sensors.empty()) firstSensor = sensors.begin()->first;
}

CarmenOdometry CarmenSurvey::odometryOf(const std::string& sensor) const
{
  const auto found = sensors.find(sensor);
  if (found != sensors.end() && !found->second.odometryIsZero) return CarmenOdometry::Scans;
  return odometryMoves ? CarmenOdometry::OdometryMessages : CarmenOdometry::None;
}

CarmenSurvey surveyCarmenLog(const std::string& path)
{
  CarmenSurvey survey;
  GzipLines lines(path);
  survey.exists = lines.isOpen();
  CarmenMessage message;
  for (std::string_view line; lines.next(line);)
  {
    parseCarmenMessage(line, message);
    add(message, lines.number(), survey);
  }
  survey.lines = lines.number();
  survey.error = survey.exists ? lines.error() : "";
  return survey;
}
}  // namespace psmks
