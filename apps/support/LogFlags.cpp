/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/support/LogFlags.h>
#include <psmks/geometry/Angle.h>

#include <CLI/CLI.hpp>

namespace psmks
{
namespace
{
constexpr const char* kIpc = "ipc";
constexpr const char* kLogger = "logger";

std::optional<double> toRadians(const std::optional<double>& angle_deg)
{
  return angle_deg ? std::make_optional(degToRad(*angle_deg)) : std::nullopt;
}
}  // namespace

void LogFlags::addTo(CLI::App& app)
{
  constexpr double kSmallest = 1e-3, kCircle_deg = 360, kFarthest_m = 1e4;
  const CLI::Range angle(kSmallest, kCircle_deg), range(kSmallest, kFarthest_m);
  app.add_option("-s,--sensor", sensor_, "scanner to use; default: that of the first scan")
      ->type_name("LABEL");
  app.add_option("--carmen-resolution_deg", increment_deg_,
                 "CARMEN logs: angle between rays; default: as logged, else by their number")
      ->type_name("DEG")
      ->check(angle);
  app.add_option(
         "--carmen-fov_deg", fieldOfView_deg_,
         "CARMEN logs: field of view, half of it to the right; default: as logged, else 180")
      ->type_name("DEG")
      ->check(angle);
  app.add_option("--carmen-max-range_m", maxRange_m_,
                 "CARMEN logs: from here on a range is no return; default: as logged, else the "
                 "largest range where it stands out")
      ->type_name("M")
      ->check(range);
  app.add_option("--carmen-stamps", stamp_,
                 "CARMEN logs: which of a message's two times; default: ipc, unless all are 0")
      ->type_name("ipc|logger")
      ->check(CLI::IsMember({kIpc, kLogger}));
  app.add_option("--bag-odometry", bagOdometry_,
                 "ROS bags: topic of the odometry; default: that with most messages, else /tf")
      ->type_name("TOPIC");
  app.add_option("--bag-sensor-pose", bagSensorPose_,
                 "ROS bags: where the scanner sits on the robot; default: by /tf and /tf_static")
      ->type_name("X_M,Y_M,PHI_DEG")
      ->delimiter(',')
      ->expected(3);
}

LogOptions LogFlags::options() const
{
  LogOptions options;
  options.sensorLabel = sensor_;
  options.carmen.increment_rad = toRadians(increment_deg_);
  options.carmen.fieldOfView_rad = toRadians(fieldOfView_deg_);
  options.carmen.maxRange_m = maxRange_m_;
  options.rosBag.odometryTopic = bagOdometry_;
  if (bagSensorPose_.size() == 3)
    options.rosBag.T_robot_sensor =
        Pose2{bagSensorPose_[0], bagSensorPose_[1], degToRad(bagSensorPose_[2])};
  if (stamp_) options.carmen.stamp = *stamp_ == kIpc ? CarmenStamp::Ipc : CarmenStamp::Logger;
  return options;
}
}  // namespace psmks
