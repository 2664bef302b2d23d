/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/sim/Laser.h>

namespace psmks
{
SimulatedScan castScan(const Surroundings& surroundings, const SensorMotion& T_world_sensor,
                       double time_s, const LaserOptions& laser, std::mt19937_64& random)
{
  SimulatedScan simulated;
  simulated.scan.grid = laser.grid;
  simulated.scan.maxRange_m = laser.maxRange_m;
  const Pose2 pose = T_world_sensor(0);
  const Eigen::Matrix2d R_world_sensor = pose.rotation();
  std::normal_distribution<double> noise(0, laser.rangeSigma_m);
  for (int ray = 0; ray < laser.grid.count(); ++ray)
  {
    const Hit hit = surroundings.cast(
        pose.translation(), R_world_sensor * laser.grid.direction(ray), laser.maxRange_m, time_s);
    const bool returned = hit.object != Hit::kNothing;
    const double noise_m = noise(random);
    simulated.scan.range_m.push_back(returned ? hit.range_m + noise_m : 0);
    simulated.noise_m.push_back(returned ? noise_m : 0);
    simulated.objectOfRay.push_back(hit.object);
  }
  return simulated;
}

SimulatedScan castScan(const Surroundings& surroundings, const Pose2& T_world_sensor,
                       const LaserOptions& laser, std::mt19937_64& random)
{
  return castScan(
      surroundings, [&T_world_sensor](double) { return T_world_sensor; }, 0, laser, random);
}
}  // namespace psmks
