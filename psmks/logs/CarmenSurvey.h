/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/logs/CarmenMessage.h>
#include <psmks/logs/CarmenOptions.h>
#include <psmks/logs/NoReturnReading.h>

#include <map>
#include <optional>
#include <string>

namespace psmks
{
/** The number of occurrences of something in a log, and the line of the first one. */
struct CarmenFinding
{
  int times = 0;
  int firstLine = 0;

  void add(int line)
  {
    if (times++ == 0) firstLine = line;
  }
};

/** Statistics of one of the two stamps of the scans of a sensor. */
struct CarmenStampSurvey
{
  int stamps = 0;
  double last_s = 0;
  bool isAboveZero = false;  //!< whether one of the stamps is above zero
  bool changes = false;
  CarmenFinding repeated, backwards;

  void add(double stamp_s, int line);

  /** Whether the stamps can be times: they are not all zero, and not all the same. */
  bool isMeaningful() const { return isAboveZero && (changes || stamps == 1); }
};

/** Statistics of the scans of a sensor. */
struct CarmenSensorSurvey
{
  int scans = 0;
  int rays = 0;                 //!< number of rays of the first scan
  CarmenScanner scanner;        //!< what the first scan states of it
  bool odometryIsZero = true;   //!< whether the odometry of all scans is zero
  Pose2 T_robot_sensor;         //!< mounting according to the first message of a ROBOTLASER
  bool mountingVaries = false;  //!< whether a later message has another mounting
  CarmenStampSurvey ipc, logger;
  NoReturnReading noReturn;

  void add(const CarmenMessage& message, int line);
};

/** The messages that the odometry of the robot is taken from. */
enum class CarmenOdometry
{
  None,
  Scans,
  OdometryMessages  //!< because the odometry of all scans is zero
};

/** What has to be known about a whole CARMEN log before its first scan can be read. */
struct CarmenSurvey
{
  bool exists = false;
  int lines = 0;
  int messages = 0;  //!< number of those that are read, including malformed ones
  CarmenFinding malformed;
  std::map<std::string, double> parameters;  //!< those that are numbers; the last value counts
  std::map<std::string, CarmenSensorSurvey> sensors;
  std::string firstSensor;
  bool odometryMoves = false;  //!< whether an ODOM message has a pose other than zero
  std::string error;           //!< see GzipLines::error()

  /** The stamp to use for a sensor: the wanted one, or by default that of IPC, else that of the
   * logger. A stamp that is not meaningful is not used.
   *  @return nothing if there is no such stamp */
  std::optional<CarmenStamp> stampOf(const std::string& sensor,
                                     const std::optional<CarmenStamp>& wanted) const;

  /** Leaves out the sensors of RAWLASER messages where another kind of message has at least half as
   * many scans: the log then holds the same scans once more, with the pose of the robot. */
  void leaveOutRepetitions();

  /** The messages to take the odometry of a sensor from. */
  CarmenOdometry odometryOf(const std::string& sensor) const;
};

/** Reads a log from its beginning to its end. */
CarmenSurvey surveyCarmenLog(const std::string& path);
}  // namespace psmks
