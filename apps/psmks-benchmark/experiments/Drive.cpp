/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/experiments/Drive.h>
#include <psmks/sim/AreaCenterDriver.h>
#include <psmks/sim/People.h>
#include <psmks/sim/WaypointDriver.h>
#include <psmks/sim/WorldIndex.h>

#include <memory>
#include <utility>

namespace psmks
{
namespace
{
std::unique_ptr<Driver> makeDriver(const Site& site, const RobotOptions& robot, unsigned seed)
{
  if (site.route) return std::make_unique<WaypointDriver>(WaypointOptions(), robot, *site.route);
  return std::make_unique<AreaCenterDriver>(AreaCenterOptions(), robot, seed);
}
}  // namespace

Drive makeDrive(const DrivePlan& plan, const std::function<void(double)>& progress)
{
  Drive drive;
  drive.plan = plan;
  drive.site = makeSite(plan.site, plan.seed);
  for (auto& person : peopleAround(WorldIndex(drive.site.world),
                                   drive.site.T_world_start.translation(), plan.people, plan.seed))
    drive.site.world.addMovingObject(std::move(person));
  drive.simulation.duration_s = plan.duration_s;
  drive.simulation.laser.maxRange_m = plan.maxRange_m;
  drive.simulation.seed = plan.seed;
  const auto driver = makeDriver(drive.site, drive.simulation.robot, plan.seed);
  drive.recording = simulate(WorldIndex(drive.site.world), drive.site.T_world_start, *driver,
                             drive.simulation, progress);
  return drive;
}
}  // namespace psmks
