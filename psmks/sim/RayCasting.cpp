/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/sim/RayCasting.h>

namespace psmks
{
SimulatedScan castScan(const World& world, const Pose2& T_world_sensor, const Scanner& scanner,
                       std::mt19937_64& random)
{
  SimulatedScan simulated;
  simulated.scan.grid = scanner.grid;
  simulated.scan.maxRange_m = scanner.maxRange_m;
  const Eigen::Matrix2d R_world_sensor = T_world_sensor.rotation();
  std::normal_distribution<double> noise(0, 1);
  for (int ray = 0; ray < scanner.grid.count(); ++ray)
  {
    const World::Hit hit =
        world.cast(T_world_sensor.translation(), R_world_sensor * scanner.grid.direction(ray),
                   scanner.maxRange_m);
    const bool returned = hit.wall != World::Hit::kNothing;
    const double range_m = hit.range_m + scanner.rangeSigma_m * noise(random);
    simulated.scan.range_m.push_back(returned ? range_m : 0);
    simulated.wallOfRay.push_back(hit.wall);
  }
  return simulated;
}
}  // namespace psmks
