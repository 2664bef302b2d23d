/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-simulate/OutputFiles.h>
#include <apps/psmks-simulate/Place.h>
#include <apps/psmks-simulate/Simulate.h>
#include <apps/support/ExitCode.h>
#include <apps/support/Progress.h>
#include <apps/support/StopSignal.h>
#include <psmks/base/Stopwatch.h>
#include <psmks/sim/AreaCenterDriver.h>
#include <psmks/sim/WaypointDriver.h>

#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <iostream>

namespace psmks
{
namespace
{
/** The time of a whole turn of a beam that sweeps over the rays as the laser states. */
double turnOf_s(const LaserOptions& laser)
{
  const double swept_rad = (laser.grid.count() - 1) * laser.grid.increment_rad();
  return laser.sweepDuration_s * 2 * kPi / swept_rad;
}

SimulationOptions simulationOptions(const CommandLine& c)
{
  constexpr double kSecondsPerMinute = 60;
  SimulationOptions options;
  options.robot.wheelNoise = c.wheelNoise;
  options.laser.grid = BeamGrid::centered(degToRad(c.fieldOfView_deg), c.rays);
  options.laser.maxRange_m = c.maxRange_m;
  options.laser.rangeSigma_m = c.rangeSigma_m;
  options.laser.quantum_m = c.quantum_m;
  options.laser.dropOutShare = c.dropOutShare;
  options.laser.beamDivergence_rad = degToRad(c.beamDivergence_deg);
  options.laser.sweepDuration_s = c.sweep_s;
  options.laser.interleavedTurns = c.interleavedTurns;
  options.laser.turn_s = turnOf_s(options.laser);
  options.T_robot_sensor = {c.laserX_m, c.laserY_m, wrapAngle(degToRad(c.laserPhi_deg))};
  options.duration_s = kSecondsPerMinute * c.minutes;
  options.seed = c.seed;
  if (options.laser.duration_s() > options.scanPeriod_s)
    throw ProgramError(kUsage, "--sweep_s and --interleaved_turns: a scan would take longer than " +
                                   std::to_string(options.scanPeriod_s) + " s, its period");
  return options;
}

RawlogWriter::Options logOptions(const CommandLine& c, const SimulationOptions& simulation)
{
  RawlogWriter::Options options;
  options.format = c.format == "actions" ? RawlogFormat::Actions : RawlogFormat::Observations;
  options.T_robot_sensor = simulation.T_robot_sensor;
  return options;
}

std::unique_ptr<Driver> makeDriver(const CommandLine& c, const Place& place,
                                   const RobotOptions& robot)
{
  if (!place.route.empty())
    return std::make_unique<WaypointDriver>(WaypointOptions(), robot, place.route);
  if (c.driver == "route")
    throw ProgramError(kUsage, "'" + c.world + "' has no route of its own, add --route");
  return std::make_unique<AreaCenterDriver>(AreaCenterOptions(), robot, c.seed);
}

/** The mean time to cast a scan, measured by casting some of the scans again. */
double castingTime_s(const Surroundings& surroundings, const Recording& recording,
                     const LaserOptions& laser)
{
  constexpr std::size_t kScans = 500;
  const std::size_t every = std::max<std::size_t>(1, recording.scans.size() / kScans);
  std::mt19937_64 random;
  int scans = 0;
  Stopwatch watch;
  for (std::size_t i = 0; i < recording.scans.size(); i += every, ++scans)
    castScan(surroundings, recording.scans[i].T_world_robot * recording.T_robot_sensor, laser,
             random);
  return watch.lap_s() / scans;
}

/** Ends a drive where a signal asks the program to stop, after one scan at the earliest. */
class StoppedDriver : public Driver
{
 public:
  explicit StoppedDriver(Driver& driver) : driver_(driver) {}

  WheelSpeeds drive(const DriverView& view) override
  {
    hasDriven_ = true;
    return driver_.drive(view);
  }

  bool isDone() const override { return driver_.isDone() || (hasDriven_ && isToStop()); }

 private:
  Driver& driver_;
  bool hasDriven_ = false;
};

WorldPicture pictureOf(const CommandLine& c, const Place& place, const Recording& recording)
{
  const std::string name = std::filesystem::path(c.world).filename().string();
  WorldPicture picture{name + ", seed " + std::to_string(c.seed), place.drawn, place.route, {}};
  for (const auto& scan : recording.scans) picture.path.push_back(scan.T_world_robot);
  return picture;
}

void printSummary(std::ostream& out, const CommandLine& c, const Place& place,
                  const Recording& recording, bool routeDone, double casting_s)
{
  constexpr double kUsPerSecond = 1e6;
  const auto& scans = recording.scans;
  const double duration_s =
      scans.back().simulated.scan.stamp_s - scans.front().simulated.scan.stamp_s;
  out << std::fixed << std::setprecision(1);
  out << "world            " << c.world << ": " << place.contents << ", "
      << place.drawn.movingObjects().size() << " people\n";
  out << "scans            " << scans.size() << " of " << c.rays << " rays in " << duration_s
      << " s\n";
  out << "driven           " << recording.distance_m() << " m, " << recording.turns() << " turns";
  if (!place.route.empty()) out << (routeDone ? ", to the end of the route" : ", short of the end");
  out << "\ncollisions       " << recording.collisions() << ", longest standstill "
      << recording.longestStandstill_s() << " s\n";
  out << "ray casting      " << kUsPerSecond * casting_s << " us a scan\n";
}
}  // namespace

void simulateDrive(const CommandLine& commandLine)
{
  const SimulationOptions options = simulationOptions(commandLine);
  const Place place = loadPlace(commandLine, options.robot.radius_m);
  const auto driver = makeDriver(commandLine, place, options.robot);
  OutputFiles files(commandLine.output, commandLine.overwrite, logOptions(commandLine, options));

  const Recording recording = [&]
  {
    Progress progress("psmks-simulate");
    StoppedDriver stopped(*driver);
    return simulate(*place.surroundings, place.T_world_start, stopped, options,
                    [&](double share) { progress.show(share); });
  }();
  files.write(recording, options.laser.rangeSigma_m);
  files.write(pictureOf(commandLine, place, recording));
  printSummary(std::cout, commandLine, place, recording, driver->isDone(),
               castingTime_s(*place.surroundings, recording, options.laser));
  std::cout << "rawlog           " << files.rawlog() << "\nground truth     " << files.tum() << ", "
            << files.groundTruth() << "\npicture          " << files.picture() << '\n';
  files.requireComplete();
}
}  // namespace psmks
