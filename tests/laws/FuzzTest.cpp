/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <tests/laws/Schemes.h>

#include <Eigen/Cholesky>
#include <cstdlib>
#include <limits>

namespace psmks
{
namespace
{
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

/** How many scans are tried. PSMKS_FUZZ_SCANS in the environment replaces the number, for
 * sanitizers are slow.
 */
int scansToTry()
{
  constexpr int kScans = 1000;
  const char* fewer = std::getenv("PSMKS_FUZZ_SCANS");
  return fewer ? std::atoi(fewer) : kScans;
}

/** Random scans with all kinds of errors that no scanner should deliver. */
class BadScans
{
 public:
  explicit BadScans(test::RandomNumbers& random) : random_(random) {}

  Scan next()
  {
    Scan scan = random_.integer(0, 2) ? tamperedRoom() : noise();
    constexpr double sigmas_m[] = {0, 0.01, kNan, -1, 1e-12};
    scan.rangeSigma_m = sigmas_m[random_.integer(0, 4)];
    if (random_.integer(0, 3) == 0) scan.maxRange_m = 0;
    if (random_.integer(0, 3) == 0) flagSome(scan);
    if (random_.integer(0, 19) == 0) scan.range_m.resize(scan.range_m.size() / 2);
    return scan;
  }

 private:
  /** A grid between one without rays and a full circle with many. */
  BeamGrid grid()
  {
    const int count = random_.integer(0, 3) ? random_.integer(4, 500) : random_.integer(0, 3);
    if (random_.integer(0, 1)) return BeamGrid::centered(2 * kPi, count);
    return {random_.uniform(-kPi, kPi), random_.uniform(1e-4, 2 * kPi / (count + 1)), count};
  }

  double badRange_m()
  {
    switch (random_.integer(0, 6))
    {
      case 0:
        return kNan;
      case 1:
        return random_.integer(0, 1) ? kInf : -kInf;
      case 2:
        return 0;
      case 3:
        return -random_.uniform(0, 10);
      case 4:
        return std::pow(10, random_.uniform(-308, 308));
      default:
        return random_.uniform(0, 30);
    }
  }

  Scan noise()
  {
    Scan scan;
    scan.grid = grid();
    scan.maxRange_m = 30;
    for (int i = 0; i < scan.grid.count(); ++i) scan.range_m.push_back(badRange_m());
    return scan;
  }

  Scan tamperedRoom()
  {
    std::mt19937 rng(static_cast<unsigned>(random_.integer(0, 1 << 30)));
    const Pose2 T_world_sensor{random_.uniform(-1, 1), random_.uniform(-1, 1),
                               random_.uniform(-kPi, kPi)};
    Scan scan = castScan(officeRoom(), T_world_sensor, grid(), 30, 0.01, rng);
    const double share = random_.uniform(0, 0.5);
    for (double& range_m : scan.range_m)
      if (random_.uniform(0, 1) < share) range_m = badRange_m();
    return scan;
  }

  void flagSome(Scan& scan)
  {
    for (std::size_t i = 0; i < scan.range_m.size(); ++i)
      scan.valid.push_back(random_.integer(0, 9) > 0);
  }

  test::RandomNumbers& random_;
};

class Fuzz : public SchemeLaw
{
 protected:
  Guess randomGuess()
  {
    Guess guess;
    const double reach = random_.integer(0, 9) ? 1 : 1e12;
    guess.T_ref_cur = {reach * random_.normal(1), reach * random_.normal(1),
                       random_.uniform(-10, 10)};
    if (random_.integer(0, 2) == 0)
      guess.covariance =
          Eigen::Vector3d(0.01, 0.02, 0.005).asDiagonal() * random_.uniform(1e-6, 10);
    if (random_.integer(0, 49) == 0) guess.T_ref_cur.x_m = kNan;
    if (random_.integer(0, 49) == 0) guess.covariance = Eigen::Matrix3d::Zero().eval();
    return guess;
  }
};

INSTANTIATE_TEST_SUITE_P(Schemes, Fuzz, testing::ValuesIn(bothSchemes()), schemeName);
}  // namespace

TEST_P(Fuzz, BadScansNeitherThrowNorGiveNan)
{
  const int count = scansToTry();
  BadScans scans(random_);
  Scan reference = scans.next();
  for (int i = 0; i < count; ++i)
  {
    const Scan current = scans.next();
    const Guess guess = randomGuess();
    const MatchResult result = match(reference, current, guess);
    EXPECT_NE(result.status, MatchStatus::NotRun);
    EXPECT_TRUE(result.T_ref_cur.isFinite()) << "scan " << i << ": " << result.report();
    EXPECT_TRUE(result.covariance.allFinite()) << "scan " << i << ": " << result.report();
    EXPECT_TRUE(result.covariance.isApprox(result.covariance.transpose(), 1e-9)) << "scan " << i;
    EXPECT_EQ(result.covariance.llt().info(), Eigen::Success)
        << "scan " << i << ": " << result.report() << '\n'
        << result.covariance;
    EXPECT_TRUE(result.score >= 0 && result.score <= 1) << "scan " << i;
    const bool keepsGuess = !result.usable() && guess.T_ref_cur.isFinite();
    EXPECT_TRUE(!keepsGuess || isNearly(result.T_ref_cur, guess.T_ref_cur, 0, 0)) << "scan " << i;
    reference = current;
  }
}
}  // namespace psmks
