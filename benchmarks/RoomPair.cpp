/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <benchmarks/RoomPair.h>
#include <psmks/sim/Laser.h>
#include <psmks/sim/World.h>

namespace psmks
{
RoomPair::RoomPair(int rays)
{
  const World world = World::smallRoom();
  const Pose2 T_world_ref{-1, -2.5, degToRad(60)};
  const LaserOptions scanner{BeamGrid::centered(kPi, rays), 30, 0.01};
  std::mt19937_64 random(1);
  reference = castScan(world, T_world_ref, scanner, random).scan;
  current = castScan(world, T_world_ref * T_ref_cur_true, scanner, random).scan;
}
}  // namespace psmks
