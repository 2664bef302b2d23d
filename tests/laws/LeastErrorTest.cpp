/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/core/Matcher.h>
#include <psmks/sim/AreaCenterDriver.h>
#include <psmks/sim/PoseBound.h>
#include <psmks/sim/Simulation.h>
#include <psmks/sim/WorldIndex.h>
#include <psmks/sim/Worlds.h>

#include <cmath>
#include <vector>

namespace psmks
{
namespace
{
/** A drive of one minute through a world of the experiments. */
struct ShortDrive
{
  Site site;
  SimulationOptions simulation;
  Recording recording;

  ShortDrive(const std::string& world, unsigned seed) : site(makeSite(world, seed))
  {
    simulation.laser.maxRange_m = 30;
    simulation.duration_s = 60;
    simulation.seed = seed;
    AreaCenterDriver driver({}, simulation.robot, seed);
    recording = simulate(WorldIndex(site.world), site.T_world_start, driver, simulation);
  }
};

/** The differences between the squared errors of a matcher and of maximum likelihood on the same
 * scans. */
class SquaredErrors
{
 public:
  void add(double matcher, double mostLikely)
  {
    matcher_ += matcher;
    mostLikely_ += mostLikely;
    differences_.push_back(matcher - mostLikely);
  }

  std::size_t count() const { return differences_.size(); }
  double ratio() const { return matcher_ / mostLikely_; }

  /** By how many standard errors the mean of the matcher is above that of maximum likelihood. */
  double standardErrorsAbove() const
  {
    const auto n = static_cast<double>(differences_.size());
    const double mean = (matcher_ - mostLikely_) / n;
    double squares = 0;
    for (const double difference : differences_)
      squares += (difference - mean) * (difference - mean);
    return mean / std::sqrt(squares / (n * (n - 1)));
  }

 private:
  double matcher_ = 0, mostLikely_ = 0;
  std::vector<double> differences_;
};

struct DriveErrors
{
  SquaredErrors position_m2, heading_rad2;
};

bool isTriggered(const Pose2& T_ref_cur)
{
  return T_ref_cur.translation().norm() >= 0.8 || std::abs(T_ref_cur.phi_rad) >= degToRad(20);
}

/** Matches scans that are one trigger distance apart, with the odometry as the guess. Pairs that
 * leave a direction unconstrained are not compared. */
void compare(const ShortDrive& drive, DriveErrors& errors)
{
  const Matcher matcher;
  MatcherWorkspace workspace;
  const auto& scans = drive.recording.scans;
  const RecordedScan* reference = &scans.front();
  for (const RecordedScan& current : scans)
  {
    const Pose2 odometry = reference->T_start_odometry.inverse() * current.T_start_odometry;
    if (!isTriggered(odometry)) continue;
    const RecordedScan& ref = *reference;
    reference = &current;
    const MatchResult match =
        matcher.match(ref.simulated.scan, current.simulated.scan, {odometry, {}}, workspace);
    if (match.status != MatchStatus::Converged) continue;

    const Pose2 truth = ref.T_world_robot.inverse() * current.T_world_robot;
    const PoseBound bound =
        poseBound(drive.site.world, ref.T_world_robot, ref.simulated, current.T_world_robot,
                  current.simulated, drive.simulation.laser.rangeNoise());
    const Eigen::Vector3d mostLikely =
        mostLikelyError(bound, Eigen::Vector3d::Zero(), Eigen::Matrix3d::Identity());
    errors.position_m2.add((match.T_ref_cur.translation() - truth.translation()).squaredNorm(),
                           mostLikely.head<2>().squaredNorm());
    const double turned_rad = wrapAngle(match.T_ref_cur.phi_rad - truth.phi_rad);
    errors.heading_rad2.add(turned_rad * turned_rad, mostLikely.z() * mostLikely.z());
  }
}
/** A world and the factor by which the mean squared errors of the matcher may exceed the least
 * ones. Maximum likelihood knows which points of the curved world lie on one circle, while the
 * matcher has to find out. */
struct Place
{
  const char* world;
  double mostAbove;
};

void PrintTo(const Place& place, std::ostream* out) { *out << place.world; }

class LeastError : public testing::TestWithParam<Place>
{
};

INSTANTIATE_TEST_SUITE_P(Worlds, LeastError,
                         testing::Values(Place{"room", 2}, Place{"clutter", 2}, Place{"curved", 3},
                                         Place{"corridors", 2}),
                         [](const auto& place) -> std::string { return place.param.world; });
}  // namespace

/** DriftBound is computed from these errors. Maximum likelihood knows which ray met which object,
 * so to first order a matcher can be better only by chance. One that was better on average would
 * show that the bound is wrong. */
TEST_P(LeastError, IsThatOfMaximumLikelihood)
{
  constexpr double kChance = 3;
  DriveErrors errors;
  for (const unsigned seed : {1U, 2U, 3U}) compare(ShortDrive(GetParam().world, seed), errors);
  ASSERT_GT(errors.position_m2.count(), 100U);
  for (const SquaredErrors& squared : {errors.position_m2, errors.heading_rad2})
  {
    EXPECT_GT(squared.standardErrorsAbove(), -kChance) << "ratio " << squared.ratio();
    EXPECT_LT(squared.ratio(), GetParam().mostAbove);
  }
}
}  // namespace psmks
