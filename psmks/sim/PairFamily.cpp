/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/sim/ClutteredRoom.h>
#include <psmks/sim/OfficeFloor.h>
#include <psmks/sim/PairFamily.h>

#include <cmath>
#include <stdexcept>

namespace psmks
{
namespace
{
/** Two bare walls. Nothing else is within the range of the scanner. */
Site makeBareCorridor(unsigned seed)
{
  constexpr double kLength_m = 400, kNarrowest_m = 1.8, kWidest_m = 2.6;
  std::mt19937_64 random(seed);
  World world;
  world.addBox(
      {0, 0}, {kLength_m, std::uniform_real_distribution<double>(kNarrowest_m, kWidest_m)(random)});
  return {world, {}, std::nullopt};
}

LaserOptions scanner(double fieldOfView_deg, int rays, double maxRange_m)
{
  LaserOptions laser;
  laser.grid = BeamGrid::centered(degToRad(fieldOfView_deg), rays);
  laser.maxRange_m = maxRange_m;
  return laser;
}

LaserOptions lms() { return scanner(180, 361, 30); }
LaserOptions shortSightedLms() { return scanner(180, 361, 8); }

PairFamily office(const std::string& name, const std::string& description,
                  const LaserOptions& laser)
{
  PairFamily family{name, description, laser};
  family.makeSite = makeOfficeFloor;
  return family;
}

PairFamily withPeople(PairFamily family, int people)
{
  family.people = people;
  return family;
}

PairFamily in(Site (*makeSite)(unsigned seed), PairFamily family)
{
  family.makeSite = makeSite;
  return family;
}

PairFamily small(PairFamily family)
{
  family.maxTranslation_m = 0.15;
  family.maxRotation_rad = degToRad(5);
  return family;
}

PairFamily large(PairFamily family)
{
  family.maxTranslation_m = 1;
  family.maxRotation_rad = degToRad(20);
  return family;
}

PairFamily farApart(PairFamily family)
{
  family.maxTranslation_m = 1;
  family.maxRotation_rad = degToRad(40);
  return family;
}

void addPlain(std::vector<PairFamily>& families)
{
  struct Kind
  {
    std::string name, description;
    LaserOptions laser;
  };
  for (const Kind& kind : {Kind{"L180", "361 rays over 180 degrees, 30 m", lms()},
                           Kind{"L360", "360 rays all round, 30 m", scanner(360, 360, 30)},
                           Kind{"L180r8", "361 rays over 180 degrees, 8 m", shortSightedLms()}})
  {
    const auto named = [&kind](const std::string& size, const std::string& displacement)
    { return office(kind.name + size, kind.description + ", " + displacement, kind.laser); };
    families.push_back(small(named("_small", "up to 0.15 m and 5 degrees apart")));
    families.push_back(named("_medium", "up to 0.5 m and 15 degrees apart"));
    families.push_back(large(named("_large", "up to 1 m and 20 degrees apart")));
  }
  families.push_back(withPeople(office("L180dyn_medium", "L180_medium with 3 people", lms()), 3));
  families.push_back(
      withPeople(office("L360dyn_medium", "L360_medium with 3 people", scanner(360, 360, 30)), 3));
  families.push_back(in(makeBareCorridor, small(office("L180corr_small", "bare corridor, small",
                                                       shortSightedLms()))));
}

/** Half a degree in two interleaved turns of a SICK LMS 200, on a robot that drives and turns. */
PairFamily interleaved()
{
  /** A fast indoor robot, which drives ahead and does not slide much to the sides. */
  constexpr PlanarVelocity kFastest{1, 0.1, degToRad(60)};
  PairFamily family =
      office("interleaved", "two interleaved turns, at up to 1 m/s and 60 deg/s", lms());
  family.laser.turn_s = 1.0 / 75;
  family.laser.sweepDuration_s = family.laser.turn_s / 2;
  family.laser.interleavedTurns = 2;
  family.fastest = kFastest;
  return family;
}

/** Adds families that differ from L180_medium in one property each. */
void addHarder(std::vector<PairFamily>& families)
{
  const auto flawed = [](double LaserOptions::*flaw, double value)
  {
    LaserOptions laser = lms();
    laser.*flaw = value;
    return laser;
  };
  constexpr double kBeam_rad = degToRad(0.5);  // so wide that neighbouring beams touch
  families.push_back(
      in(makeCurved, office("curved", "rooms full of round and thin things", lms())));
  families.push_back(
      office("sigma3", "range noise of 3 cm", flawed(&LaserOptions::rangeSigma_m, 0.03)));
  families.push_back(
      office("quantised", "ranges rounded to 5 cm", flawed(&LaserOptions::quantum_m, 0.05)));
  families.push_back(
      office("dropouts", "10 % of the returns lost", flawed(&LaserOptions::dropOutShare, 0.10)));
  for (const int percent : {50, 60, 70})
    families.push_back(office("dropouts" + std::to_string(percent),
                              std::to_string(percent) + " % of the returns lost",
                              flawed(&LaserOptions::dropOutShare, percent / 100.0)));
  for (const int k : {2, 3, 4})
  {
    LaserOptions sparse = lms();
    sparse.returnEvery = k;
    families.push_back(office("every" + std::to_string(k),
                              "only one of " + std::to_string(k) + " rays returns", sparse));
  }
  families.push_back(office("mixed", "beams of 0.5 degrees: mixed pixels at edges",
                            flawed(&LaserOptions::beamDivergence_rad, kBeam_rad)));
  LaserOptions smoothing = lms();
  smoothing.smoothedRays = 3;
  families.push_back(office("smoothed", "noise smoothed over 3 rays", smoothing));
  LaserOptions shifting = flawed(&LaserOptions::scanOffsetSigma_m, 0.002);
  shifting.scanBearingSigma_rad = degToRad(0.05);
  families.push_back(office("shifted", "whole scans off by 2 mm and 0.05 degrees", shifting));
  families.push_back(interleaved());
  families.push_back(office("fov90", "181 rays over 90 degrees", scanner(90, 181, 30)));
  families.push_back(withPeople(office("people", "a crowd of 6 people", lms()), 6));
  families.push_back(
      in(makeBareCorridor, office("corridor", "bare corridor, medium", shortSightedLms())));
}

/** Adds families with the numbers of rays of real scanners. */
void addRayCounts(std::vector<PairFamily>& families)
{
  families.push_back(office("rays181", "181 rays over 180 degrees (SICK LMS 200 at 1 degree)",
                            scanner(180, 181, 30)));
  families.push_back(
      farApart(office("rays181_far", "181 rays over 180 degrees, up to 1 m and 40 degrees apart",
                      scanner(180, 181, 30))));
  families.push_back(office("rays361", "361 rays over 90 degrees (as SICK LMS 200 at 0.25 degrees)",
                            scanner(90, 361, 30)));
  families.push_back(
      office("rays720", "720 rays all round, 12 m (as Slamtec RPLIDAR A2)", scanner(360, 720, 12)));
  families.push_back(
      office("rays1081", "1081 rays over 270 degrees (Hokuyo UTM-30LX)", scanner(270, 1081, 30)));
}

/** Adds families with the scanners of config/sensors and the noise that their data sheets state. */
void addScanners(std::vector<PairFamily>& families)
{
  const auto noisy = [](LaserOptions laser, const RangeNoise& noise)
  {
    laser.rangeSigma_m = noise.sigma_m;
    laser.rangeSigmaPerMetre_m = noise.sigmaPerMetre_m;
    return laser;
  };
  const auto add =
      [&families](const std::string& name, const std::string& scanner, const LaserOptions& laser)
  { families.push_back(office(name, scanner, laser)); };
  add("urg04lx", "Hokuyo URG-04LX: 682 rays over 240 degrees, 4 m, noise of 1 %",
      noisy(scanner(240, 682, 4), {0.005, 0.01}));
  LaserOptions smoothing = noisy(scanner(240, 682, 4), {0.004, 0.005});
  smoothing.smoothedRays = 3;
  add("urg04lx_smoothed", "the same with noise of 0.5 % that is smoothed over 3 rays", smoothing);
  families.push_back(in(makeLegs, office("legs", "the same among legs, without walls", smoothing)));
  add("utm30lx", "Hokuyo UTM-30LX: 1081 rays over 270 degrees, 30 m, 1 cm and 0.1 %",
      noisy(scanner(270, 1081, 30), {0.01, 0.001}));
  add("rplidar", "Slamtec RPLIDAR A: 400 rays all round, 12 m, noise of 1 %",
      noisy(scanner(360, 400, 12), {0.005, 0.01}));
  add("tim5xx", "SICK TiM5xx: 811 rays over 270 degrees, 10 m, noise of 2 cm",
      noisy(scanner(270, 811, 10), {0.02}));
  add("lms1xx", "SICK LMS1xx: 541 rays over 270 degrees, 20 m, noise of 12 mm",
      noisy(scanner(270, 541, 20), {0.012}));
}

std::vector<PairFamily> makeFamilies()
{
  std::vector<PairFamily> families;
  addPlain(families);
  addHarder(families);
  addRayCounts(families);
  addScanners(families);
  return families;
}
}  // namespace

// Rounding adds an error that is uniformly distributed over one quantum.
RangeNoise PairFamily::rangeNoise() const
{
  const double sigma_m =
      std::sqrt(laser.rangeSigma_m * laser.rangeSigma_m + laser.quantum_m * laser.quantum_m / 12);
  return {sigma_m, laser.rangeSigmaPerMetre_m};
}

// The mean of many rays of a moving mean of w has w times the variance that white noise leaves it.
RangeNoise PairFamily::equivalentWhiteNoise() const
{
  return rangeNoise().scaledTo(std::sqrt(laser.smoothedRays) * rangeNoise().sigma_m);
}

const std::vector<PairFamily>& pairFamilies()
{
  static const std::vector<PairFamily> families = makeFamilies();
  return families;
}

const PairFamily* findPairFamily(const std::string& name)
{
  for (const PairFamily& family : pairFamilies())
    if (family.name == name) return &family;
  return nullptr;
}

const PairFamily& pairFamily(const std::string& name)
{
  if (const PairFamily* family = findPairFamily(name)) return *family;
  std::string known;
  for (const PairFamily& family : pairFamilies())
    known += (known.empty() ? "" : ", ") + family.name;
  throw std::invalid_argument("unknown set of pairs '" + name + "'; known are " + known);
}
}  // namespace psmks
