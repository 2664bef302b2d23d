/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Pose2.h>
#include <psmks/logs/CarmenWriter.h>
#include <tests/unit/logs/RoomLog.h>

#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

namespace psmks::test
{
/** The stamps at the end of a message. */
inline std::string carmenStamps(double ipc_s, double logger_s)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(6) << ' ' << ipc_s << " host " << logger_s << '\n';
  return text.str();
}

inline std::string carmenPose(const Pose2& pose)
{
  std::ostringstream text;
  text << std::setprecision(12) << ' ' << pose.x_m << ' ' << pose.y_m << ' ' << pose.phi_rad;
  return text.str();
}

inline std::string carmenRanges(const std::vector<double>& ranges_m)
{
  std::ostringstream text;
  text << ' ' << ranges_m.size();
  for (const double range_m : ranges_m) text << ' ' << range_m;
  return text.str();
}

/** A FLASER message. The pose of its laser differs from the odometry, as in corrected logs. */
inline std::string flaser(const std::vector<double>& ranges_m, const Pose2& odometry, double ipc_s,
                          double logger_s = 0)
{
  return "FLASER" + carmenRanges(ranges_m) + carmenPose({9, 9, 0}) + carmenPose(odometry) +
         carmenStamps(ipc_s, logger_s);
}

inline std::string odom(const Pose2& odometry, double ipc_s)
{
  return "ODOM" + carmenPose(odometry) + " 0.2 0 0" + carmenStamps(ipc_s, ipc_s);
}

/** Writes the log of the room as a CARMEN log. */
inline void writeCarmen(const RoomLog& log, const std::string& path)
{
  CarmenWriter writer;
  writer.open(path);
  for (const auto& step : log.steps)
  {
    LaserFrame frame;
    frame.scan = step.scan;
    frame.stamp_s = step.stamp_s;
    frame.odometry = step.odometryIncrement;
    writer.write(frame);
  }
  writer.close();
}
}  // namespace psmks::test
