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
/** How often something was met, and in which line first. */
struct CarmenFinding
{
  int times = 0;
  int firstLine = 0;

  void add(int line)
  {
    if (times++ == 0) firstLine = line;
  }
};

/** One of the two stamps of the scans of a sensor. */
struct CarmenStampSurvey
{
  int stamps = 0;
  double last_s = 0;
  bool isAboveZero = false;  //!< at least once
  bool changes = false;
  CarmenFinding repeated, backwards;

  void add(double stamp_s, int line);

  /** Whether they tell the time. */
  bool isMeaningful() const { return isAboveZero && (changes || stamps == 1); }
};

/** The scans of a sensor. */
struct CarmenSensorSurvey
{
  int scans = 0;
  int rays = 0;                 //!< of the first scan
  bool odometryIsZero = true;   //!< throughout
  Pose2 T_robot_sensor;         //!< where a ROBOTLASER puts it in its first message
  bool mountingVaries = false;  //!< too far to be one, in a later message
  CarmenStampSurvey ipc, logger;
  NoReturnReading noReturn;

  void add(const CarmenMessage& message, int line);
};

/** The messages that say how the robot moved. */
enum class CarmenOdometry
{
  None,
  Scans,
  OdometryMessages  //!< since the odometry of the scans is zero throughout
};

/** What must be known of a whole CARMEN log before its first scan can be read. */
struct CarmenSurvey
{
  bool exists = false;
  int lines = 0;
  int messages = 0;  //!< of the kinds that are read, malformed ones included
  CarmenFinding malformed;
  std::map<std::string, double> parameters;  //!< those that are numbers; the last one counts
  std::map<std::string, CarmenSensorSurvey> sensors;
  std::string firstSensor;
  bool odometryMoves = false;  //!< that of the ODOM messages
  std::string error;           //!< see CarmenLines::error()

  /** The stamp to go by: the one asked for, else IPC's, if it is meaningful. None where there is
   *  none. */
  std::optional<CarmenStamp> stampOf(const std::string& sensor,
                                     const std::optional<CarmenStamp>& wanted) const;

  CarmenOdometry odometryOf(const std::string& sensor) const;
};

/** Reads a log from its beginning to its end. */
CarmenSurvey surveyCarmenLog(const std::string& path);
}  // namespace psmks
