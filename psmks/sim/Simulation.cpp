/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/sim/Simulation.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
/** Interpolates between two poses that are one noise step apart, along the chord. The arc of a step
 * is nowhere farther than a tenth of a millimetre from its chord. */
Pose2 between(const Pose2& a, const Pose2& b, double share)
{
  return {a.x_m + share * (b.x_m - a.x_m), a.y_m + share * (b.y_m - a.y_m),
          wrapAngle(a.phi_rad + share * wrapAngle(b.phi_rad - a.phi_rad))};
}

/** A simulation in progress: the robot, the time and the random engines. */
class Drive
{
 public:
  Drive(const Surroundings& surroundings, const Pose2& T_world_start,
        const SimulationOptions& options)
      : surroundings_(surroundings), options_(options), robot_(options.robot, T_world_start)
  {
    // Two engines from one seed, so that the noise of the wheels does not depend on the laser.
    std::seed_seq ofWheels{options.seed, 1U}, ofLaser{options.seed, 2U};
    wheelRandom_.seed(ofWheels);
    laserRandom_.seed(ofLaser);
  }

  /** Takes a scan, asks the driver after the sweep, and drives until the next scan. */
  RecordedScan drivePeriod(Driver& driver)
  {
    const int sweepSteps =
        static_cast<int>(std::ceil(options_.laser.duration_s() / options_.robot.noiseStep_s));
    RecordedScan recorded;
    recorded.T_world_robot = robot_.T_world_robot();
    recorded.T_start_odometry = robot_.T_start_odometry();
    recorded.bumped = bumpedSinceScan_;
    bumpedSinceScan_ = false;

    const double start_s = now_s();
    std::vector<Pose2> poses{robot_.T_world_robot()};
    for (int step = 0; step < sweepSteps; ++step)
    {
      advance();
      poses.push_back(robot_.T_world_robot());
    }
    recorded.simulated = scanAlong(poses, start_s);
    command_ = driver.drive(view(recorded.simulated.scan));
    bumpedSinceControl_ = false;
    for (int step = sweepSteps; step < stepsPerScan(); ++step) advance();
    return recorded;
  }

  int stepsPerScan() const
  {
    return static_cast<int>(std::round(options_.scanPeriod_s / options_.robot.noiseStep_s));
  }

 private:
  double now_s() const { return steps_ * options_.robot.noiseStep_s; }

  void advance()
  {
    const double before_m = clearance_m();
    robot_.advance(command_, wheelRandom_);
    ++steps_;
    // A moving object that has touched the robot must not hold it: steps that lead away are
    // allowed.
    const double after_m = clearance_m();
    if (after_m >= options_.robot.radius_m || after_m > before_m) return;
    robot_.stop();
    bumpedSinceScan_ = bumpedSinceControl_ = true;
  }

  double clearance_m() const
  {
    return surroundings_.clearance_m(robot_.T_world_robot().translation(),
                                     2 * options_.robot.radius_m, now_s());
  }

  /** Casts a scan from a moving robot.
   *  @param poses of the robot from the first ray on, one noise step apart */
  SimulatedScan scanAlong(const std::vector<Pose2>& poses, double start_s)
  {
    const auto T_world_sensor = [&](double sinceFirstRay_s)
    {
      const double step = sinceFirstRay_s / options_.robot.noiseStep_s;
      const std::size_t before = std::min(static_cast<std::size_t>(step), poses.size() - 1);
      const std::size_t after = std::min(before + 1, poses.size() - 1);
      return between(poses[before], poses[after], step - static_cast<double>(before)) *
             options_.T_robot_sensor;
    };
    SimulatedScan simulated =
        castScan(surroundings_, T_world_sensor, start_s, options_.laser, laserRandom_);
    simulated.scan.stamp_s = options_.startStamp_s + start_s;
    return simulated;
  }

  DriverView view(const Scan& scan) const
  {
    return {scan,
            options_.T_robot_sensor,
            robot_.T_start_odometry(),
            robot_.T_world_robot(),
            robot_.speeds(),
            bumpedSinceControl_,
            now_s()};
  }

  const Surroundings& surroundings_;
  const SimulationOptions& options_;
  Robot robot_;
  std::mt19937_64 wheelRandom_, laserRandom_;
  WheelSpeeds command_;
  int steps_ = 0;
  bool bumpedSinceScan_ = false, bumpedSinceControl_ = false;
};

double distance_m(const RecordedScan& a, const RecordedScan& b)
{
  return (a.T_world_robot.translation() - b.T_world_robot.translation()).norm();
}
}  // namespace

double Recording::distance_m() const
{
  double sum_m = 0;
  for (std::size_t s = 1; s < scans.size(); ++s) sum_m += psmks::distance_m(scans[s - 1], scans[s]);
  return sum_m;
}

double Recording::turns() const
{
  double sum_rad = 0;
  for (std::size_t s = 1; s < scans.size(); ++s)
    sum_rad +=
        std::abs(wrapAngle(scans[s].T_world_robot.phi_rad - scans[s - 1].T_world_robot.phi_rad));
  return sum_rad / (2 * kPi);
}

int Recording::collisions() const
{
  int count = 0;
  for (std::size_t s = 0; s < scans.size(); ++s)
    if (scans[s].bumped && !(s > 0 && scans[s - 1].bumped)) ++count;
  return count;
}

double Recording::longestStandstill_s() const
{
  constexpr double kOnePlace_m = 0.2;
  double longest_s = 0;
  std::size_t arrived = 0;
  for (std::size_t s = 0; s < scans.size(); ++s)
  {
    while (psmks::distance_m(scans[arrived], scans[s]) > kOnePlace_m) ++arrived;
    longest_s = std::max(longest_s,
                         scans[s].simulated.scan.stamp_s - scans[arrived].simulated.scan.stamp_s);
  }
  return longest_s;
}

Recording simulate(const Surroundings& surroundings, const Pose2& T_world_start, Driver& driver,
                   const SimulationOptions& options, const std::function<void(double)>& progress)
{
  Drive drive(surroundings, T_world_start, options);
  Recording recording;
  recording.T_robot_sensor = options.T_robot_sensor;
  const int periods = static_cast<int>(std::round(options.duration_s / options.scanPeriod_s));
  for (int period = 0; period <= periods && !driver.isDone(); ++period)
  {
    recording.scans.push_back(drive.drivePeriod(driver));
    if (progress && periods > 0) progress(static_cast<double>(period) / periods);
  }
  return recording;
}
}  // namespace psmks
