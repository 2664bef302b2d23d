/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <tests/laws/Schemes.h>

#include <Eigen/LU>

namespace psmks
{
namespace
{
class Uncertainty : public SchemeLaw
{
};

INSTANTIATE_TEST_SUITE_P(Schemes, Uncertainty, testing::ValuesIn(bothSchemes()), schemeName);
}  // namespace

TEST_P(Uncertainty, GrowsWithTheNoise)
{
  // Sums over the pairs, for a single pair may gain an association by its noise.
  double quietPosition_m2 = 0, noisyPosition_m2 = 0, quietHeading_rad2 = 0, noisyHeading_rad2 = 0;
  for (int i = 0; i < kPairs; ++i)
  {
    const ScanPair quiet = randomPair(kHalfCircle, 0.003);
    ScanPair noisy = quiet;
    for (Scan* scan : {&noisy.reference, &noisy.current})
    {
      scan->rangeSigma_m = 0.012;
      for (double& range_m : scan->range_m)
        if (range_m < scan->maxRange_m) range_m += random_.normal(0.012);
    }
    const MatchResult a = match(quiet.reference, quiet.current);
    const MatchResult b = match(noisy.reference, noisy.current);
    ASSERT_TRUE(a.usable() && b.usable()) << a.report() << '\n' << b.report();
    quietPosition_m2 += a.covariance(0, 0) + a.covariance(1, 1);
    noisyPosition_m2 += b.covariance(0, 0) + b.covariance(1, 1);
    quietHeading_rad2 += a.covariance(2, 2);
    noisyHeading_rad2 += b.covariance(2, 2);
  }
  EXPECT_GT(noisyPosition_m2, 1.5 * quietPosition_m2);
  EXPECT_GT(noisyHeading_rad2, 1.5 * quietHeading_rad2);
}

//  --------------------      two bare walls: the position along them is that of the guess, and the
//     o -> x                 result reports the direction, whatever the heading
//  --------------------
TEST_P(Uncertainty, ACorridorIsDegenerateAlongItself)
{
  for (int i = 0; i < kPairs; ++i)
  {
    const Pose2 T_world_ref{random_.uniform(-5, 5), random_.uniform(-0.4, 0.4),
                            random_.uniform(-kPi, kPi)};
    const Pose2 T_ref_cur{random_.uniform(-0.07, 0.07), random_.uniform(-0.07, 0.07),
                          random_.uniform(-0.05, 0.05)};
    std::mt19937 noise(static_cast<unsigned>(random_.integer(0, 1 << 30)));
    const Scan reference = castScan(corridor(), T_world_ref, kFullCircle, 8, 0.005, noise);
    const Scan current =
        castScan(corridor(), T_world_ref * T_ref_cur, kFullCircle, 8, 0.005, noise);
    const Guess guess{{random_.uniform(-0.05, 0.05), random_.uniform(-0.05, 0.05), 0}, {}};

    const MatchResult result = match(reference, current, guess);
    EXPECT_EQ(result.status, MatchStatus::Degenerate) << result.report();
    ASSERT_TRUE(result.unobservableDirection.has_value());
    const Eigen::Vector2d along(std::cos(T_world_ref.phi_rad), -std::sin(T_world_ref.phi_rad));
    const Eigen::Vector2d across(-along.y(), along.x());
    EXPECT_GT(std::abs(result.unobservableDirection->dot(along)), std::cos(degToRad(2)));

    // The direction itself is known to a fraction of a degree, over a decimetre of motion.
    const Eigen::Vector2d moved = result.T_ref_cur.translation() - guess.T_ref_cur.translation();
    EXPECT_NEAR(result.unobservableDirection->dot(moved), 0, 1e-9) << result.report();
    EXPECT_NEAR(along.dot(moved), 0, 0.005) << result.report();
    EXPECT_NEAR(across.dot(result.T_ref_cur.translation()), across.dot(T_ref_cur.translation()),
                0.01 + GetParam().tol_m)
        << result.report();
    EXPECT_NEAR(result.T_ref_cur.phi_rad, T_ref_cur.phi_rad, degToRad(0.1) + GetParam().tol_rad);
    EXPECT_GT(along.dot(result.covariance.topLeftCorner<2, 2>() * along), 0.05 * 0.05);
  }
}
}  // namespace psmks
