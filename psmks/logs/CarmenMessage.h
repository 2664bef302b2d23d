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
  Scan,       //!< FLASER, RLASER, ROBOTLASER1, ROBOTLASER2
  Odometry,   //!< ODOM
  Parameter,  //!< PARAM
  Other,      //!< a message of another name, a comment, a blank line
  Malformed   //!< a scan or an odometry whose numbers are not what their message asks for
};

/** What a ROBOTLASER message says of its scanner; none where the value makes no sense. */
struct CarmenScanner
{
  std::optional<double> firstBearing_rad, fieldOfView_rad, increment_rad, maxRange_m, sigma_m;
  std::optional<int> type;  //!< CARMEN's number of the kind of scanner: 0 SICK LMS, 1 SICK PLS, ...
};

/** One line of a CARMEN log. Which fields count depends on the kind.
 *
 *     FLASER n r1 .. rn  x y theta  odom_x odom_y odom_theta  ipc host logger
 *     ROBOTLASER1 type start fov resolution max accuracy remission_mode n r1 .. rn [m s1 .. sm]
 *         laser_x y theta  robot_x y theta  tv rv forward side turn_axis  ipc host logger
 *     ODOM x y theta  tv rv acceleration  ipc host logger
 *     PARAM name value  ipc host logger
 *
 * Metres and radians; ranges from the right to the left. */
struct CarmenMessage
{
  CarmenKind kind = CarmenKind::Other;
  std::string name;              //!< FLASER, ODOM, ..., or that of the parameter
  double value = 0;              //!< of a parameter
  std::vector<double> ranges_m;  //!< NaN and infinity where the log says so
  std::optional<CarmenScanner> scanner;
  Pose2 T_odom_laser;        //!< of a FLASER often another estimate of the robot's pose
  Pose2 T_odom_robot;        //!< as the wheels measured it
  double ipcStamp_s = 0;     //!< when the message was made
  double loggerStamp_s = 0;  //!< when it was logged; often since the logger's start; 0 = none
};

/** Parses a line without its end. A parameter that is no number is Other.
 *  @param[out] message replaced; its buffers are used again */
void parseCarmenMessage(std::string_view line, CarmenMessage& message);
}  // namespace psmks
