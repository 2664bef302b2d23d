/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Pose2.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace psmks
{
enum class CarmenKind
{
  Scan,       //!< FLASER, RLASER, ROBOTLASER1, ROBOTLASER2, RAWLASER1 to RAWLASER5
  Odometry,   //!< ODOM
  Parameter,  //!< PARAM
  Other,      //!< a message of another name, a comment, a blank line
  Malformed   //!< a scan or odometry message with wrong, missing or absurd numbers
};

/** The description of the scanner in a ROBOTLASER or RAWLASER message. A member is empty if its
 * value makes no sense. */
struct CarmenScanner
{
  std::optional<double> firstBearing_rad, fieldOfView_rad, increment_rad, maxRange_m, sigma_m;
  std::optional<int> type;  //!< kind of scanner as numbered by CARMEN: 0 SICK LMS, 1 SICK PLS, ...
};

/** One line of a CARMEN log. Its kind decides which fields are set.
 *
 *     FLASER n r1 .. rn  x y theta  odom_x odom_y odom_theta  ipc host logger
 *     ROBOTLASER1 type start fov resolution max accuracy remission_mode n r1 .. rn [m s1 .. sm]
 *         laser_x y theta  robot_x y theta  tv rv forward side turn_axis  ipc host logger
 *     RAWLASER1 type start fov resolution max accuracy remission_mode n r1 .. rn [m s1 .. sm]
 *         ipc host logger
 *     ODOM x y theta  tv rv acceleration  ipc host logger
 *     PARAM name value  ipc host logger
 *
 * All values are in metres and radians; ranges go from the right to the left. A RAWLASER message
 * has no pose: both are the origin. A byte order mark before the name and NULs are skipped. */
struct CarmenMessage
{
  CarmenKind kind = CarmenKind::Other;
  std::string name;              //!< name of the message, such as FLASER, or of the parameter
  double value = 0;              //!< value of a parameter
  std::vector<double> ranges_m;  //!< may be NaN or infinite, as in the log
  std::optional<CarmenScanner> scanner;
  Pose2 T_odom_laser;        //!< of a FLASER often a corrected pose of the robot
  Pose2 T_odom_robot;        //!< measured by odometry
  double ipcStamp_s = 0;     //!< when the message was made
  double loggerStamp_s = 0;  //!< when it was logged, often since the logger's start; 0 = none
};

/** Whether a message is of a RAWLASER, which the module of a scanner sends where no module of a
 * robot adds a pose. */
bool isRawLaser(std::string_view messageName);

/** Parses a line. A parameter that is not a number has the kind Other.
 *  @param line without its end
 *  @param[out] message overwritten; its buffers are used again */
void parseCarmenMessage(std::string_view line, CarmenMessage& message);
}  // namespace psmks
