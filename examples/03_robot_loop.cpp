/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */

/** \file
 * Example 3: localisation and mapping in a robot's loop.
 *
 * The loop hands odometry and scans over as the robot delivers them and gets the robot's pose after
 * every scan, with its covariance and with what it rests on. A made-up robot drives a circle in a
 * room while its wheels measure each turn too small. The example prints every fourth pose, and
 * where the wheels alone put the robot in the end: the circle closes by the scans, not by the
 * wheels. */

#include <mrpt/core/Clock.h>
#include <psmks/mrpt/ObservationSlam.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

using mrpt::obs::CObservation2DRangeScan;
using mrpt::obs::CObservationOdometry;
using mrpt::poses::CPose2D;

// Stands for the robot: 0.2 m and 10 degrees a second, of which its wheels measure 9 degrees,
// between the walls x = -4 m, x = 4 m, y = -3 m and y = 3 m.
struct Robot
{
  int second = 0;
  CPose2D T_room_robot{0.5, -1.5, 0};
  CPose2D T_odom_robot;

  void drive()
  {
    ++second;
    T_room_robot = T_room_robot + CPose2D(0.2, 0, psmks::degToRad(10));
    T_odom_robot = T_odom_robot + CPose2D(0.2, 0, psmks::degToRad(9));
  }

  CObservationOdometry odometry() const
  {
    CObservationOdometry odometry;
    odometry.timestamp = mrpt::Clock::fromDouble(second);
    odometry.odometry = T_odom_robot;
    return odometry;
  }

  CObservation2DRangeScan scan() const
  {
    CObservation2DRangeScan scan;
    scan.timestamp = mrpt::Clock::fromDouble(second);
    scan.aperture = static_cast<float>(psmks::degToRad(270));
    scan.resizeScanAndAssign(541, 0, true);
    for (std::size_t ray = 0; ray < scan.getScanSize(); ++ray)
    {
      const double bearing_rad = T_room_robot.phi() + scan.getScanAngle(ray);
      const double u = std::cos(bearing_rad), v = std::sin(bearing_rad);
      const double range_m = std::min((std::copysign(4, u) - T_room_robot.x()) / u,
                                      (std::copysign(3, v) - T_room_robot.y()) / v);
      scan.setScanRange(ray, static_cast<float>(range_m));
    }
    return scan;
  }
};

// To three decimals, without a minus before a zero.
double rounded(double value) { return std::round(1e3 * value) / 1e3 + 0.0; }

void print(const psmks::OnlinePose& pose)
{
  const psmks::Pose2& T = pose.T_world_robot.pose;
  const double phi_deg = psmks::radToDeg(T.phi_rad);
  const double sigma_m = std::sqrt(pose.T_world_robot.covariance(0, 0));
  std::printf("%2.0f s  %-9s  %-9s  x %6.3f m  y %6.3f m  phi %8.3f deg  sigma of x %3.1f mm\n",
              pose.stamp_s, toString(pose.source), toString(pose.match.status), rounded(T.x_m),
              rounded(T.y_m), rounded(phi_deg), 1e3 * sigma_m);
}

int main()
{
  Robot robot;
  psmks::ObservationSlam slam;  // setListener() makes it call a function after every scan, too
  while (true)
  {
    slam.addOdometry(robot.odometry());
    const psmks::OnlinePose pose = slam.addScan(robot.scan());
    if (robot.second % 4 == 0) print(pose);
    if (robot.second == 36) break;
    robot.drive();
  }
  std::printf("the wheels alone:           x %6.3f m  y %6.3f m  phi %8.3f deg\n",
              robot.T_odom_robot.x(), robot.T_odom_robot.y(),
              psmks::radToDeg(robot.T_odom_robot.phi()));
}
