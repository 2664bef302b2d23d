/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/geometry/BeamTiming.h>
#include <psmks/sim/Laser.h>

#include <cmath>
#include <deque>

namespace psmks
{
namespace
{
// A wide beam is sampled along this many thin rays, so that the share of the beam on either side of
// an edge is right to one eighth.
constexpr int kRaysPerBeam = 9;

/** One beam of a scan, which leaves from its own pose at its own time. */
struct Beam
{
  const Surroundings& surroundings;
  Eigen::Vector2d origin_m, direction;
  double time_s, maxRange_m;

  Hit hit(double aside_rad) const
  {
    const Eigen::Vector2d left(-direction.y(), direction.x());
    return surroundings.cast(origin_m, std::cos(aside_rad) * direction + std::sin(aside_rad) * left,
                             maxRange_m, time_s);
  }

  /** The mean range over the width of a beam whose middle ray returns. Rays that meet nothing do
   * not count. */
  double meanRange_m(double divergence_rad) const
  {
    double sum_m = 0;
    int returns = 0;
    for (int ray = 0; ray < kRaysPerBeam; ++ray)
    {
      const Hit aside = hit(divergence_rad * (ray / (kRaysPerBeam - 1.0) - 0.5));
      if (aside.object == Hit::kNothing) continue;
      sum_m += aside.range_m;
      ++returns;
    }
    return sum_m / returns;
  }
};

/** What the scanner reads of a beam. The default is no return. */
struct Reading
{
  double range_m = 0, noise_m = 0;
  int object = Hit::kNothing;
};

double rounded_m(double range_m, double quantum_m)
{
  return quantum_m > 0 ? std::round(range_m / quantum_m) * quantum_m : range_m;
}

bool isLost(double share, std::mt19937_64& random)
{
  return share > 0 && std::bernoulli_distribution(share)(random);
}

/** The noise of the rays of a scan, in standard deviations: moving means of white noise. */
class UnitNoise
{
 public:
  UnitNoise(int smoothedRays, std::mt19937_64& random) : random_(random)
  {
    for (int i = 1; i < smoothedRays; ++i) window_.push_back(unit_(random_));
  }

  double next()
  {
    window_.push_back(unit_(random_));
    double sum = 0;
    for (const double noise : window_) sum += noise;
    const double scaled = sum / std::sqrt(static_cast<double>(window_.size()));
    window_.pop_front();
    return scaled;
  }

 private:
  std::mt19937_64& random_;
  std::normal_distribution<double> unit_;
  std::deque<double> window_;
};

/** Errors that the rays of a scan share. */
struct SharedErrors
{
  SharedErrors(const LaserOptions& laser, std::mt19937_64& random)
  {
    const auto draw = [&random](double sigma)
    { return sigma > 0 ? std::normal_distribution<double>(0, sigma)(random) : 0; };
    range_m = draw(laser.scanOffsetSigma_m);
    bearing_rad = draw(laser.scanBearingSigma_rad);
  }

  double range_m, bearing_rad;
};

/** What the scanner reads of a beam.
 *  @param unitNoise of this ray, in standard deviations
 *  @param shared_m error that the ray has in common with others */
Reading read(const Beam& beam, const LaserOptions& laser, double unitNoise, double shared_m,
             std::mt19937_64& random)
{
  const bool lost = isLost(laser.dropOutShare, random);
  const Hit hit = beam.hit(0);
  if (lost || hit.object == Hit::kNothing) return {};
  const double returned_m =
      laser.beamDivergence_rad > 0 ? beam.meanRange_m(laser.beamDivergence_rad) : hit.range_m;
  const double noise_m = unitNoise * laser.rangeNoise().sigmaAt_m(hit.range_m) + shared_m;
  const double range_m = rounded_m(returned_m + noise_m, laser.quantum_m);
  return {range_m, range_m - hit.range_m, hit.object};
}
}  // namespace

SimulatedScan castScan(const Surroundings& surroundings, const SensorMotion& T_world_sensor,
                       double time_s, const LaserOptions& laser, std::mt19937_64& random)
{
  SimulatedScan simulated;
  simulated.scan.grid = laser.grid;
  simulated.scan.maxRange_m = laser.maxRange_m;
  simulated.scan.sweepDuration_s = laser.sweepDuration_s;
  simulated.scan.interleavedTurns = laser.interleavedTurns;
  simulated.scan.turn_s = laser.turn_s;
  const int rays = laser.grid.count();
  const SharedErrors shared(laser, random);
  simulated.bearingOffset_rad = shared.bearing_rad;
  UnitNoise unitNoise(laser.smoothedRays, random);
  for (int ray = 0; ray < rays; ++ray)
  {
    const double sinceFirst_s = sinceFirstRay_s(simulated.scan, ray);
    const Pose2 pose = T_world_sensor(sinceFirst_s);
    const double bearing_rad = laser.grid.bearing_rad(ray) + shared.bearing_rad;
    const Beam beam{surroundings, pose.translation(),
                    pose.rotation() * Eigen::Vector2d(std::cos(bearing_rad), std::sin(bearing_rad)),
                    time_s + sinceFirst_s, laser.maxRange_m};
    // Drawn for beams without return as well, so that the other rays of a scan have the same noise
    // whatever the maximum range.
    const double noise = unitNoise.next();
    Reading reading = read(beam, laser, noise, shared.range_m, random);
    if (ray % laser.returnEvery != 0) reading = {};
    simulated.scan.range_m.push_back(reading.range_m);
    simulated.noise_m.push_back(reading.noise_m);
    simulated.objectOfRay.push_back(reading.object);
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
