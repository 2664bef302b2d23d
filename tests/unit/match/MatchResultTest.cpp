/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/match/MatchResult.h>
#include <tests/support/Says.h>

#include <Eigen/LU>

namespace psmks
{
TEST(MatchResult, SaysThatNoMatchWasRun)
{
  const MatchResult result;
  EXPECT_EQ(result.status, MatchStatus::NotRun);
  EXPECT_FALSE(result.usable());
  EXPECT_FALSE(result.unobservableDirection.has_value());
  EXPECT_TRUE(test::says(result.report(), {"NotRun"}));
}

TEST(MatchResult, TheCovarianceIsNeverZero)
{
  const Eigen::Matrix3d P = MatchResult().covariance;
  EXPECT_EQ(P, MatchResult::unknownCovariance());
  EXPECT_GT(P.determinant(), 0);
  EXPECT_DOUBLE_EQ(P(0, 0), 1);
  EXPECT_DOUBLE_EQ(P(1, 1), 1);
  EXPECT_NEAR(std::sqrt(P(2, 2)), degToRad(30), 1e-12);
}

TEST(MatchResult, ConvergedMaxIterationsAndDegenerateAreUsable)
{
  const auto usable = [](MatchStatus status)
  {
    MatchResult result;
    result.status = status;
    return result.usable();
  };
  EXPECT_TRUE(usable(MatchStatus::Converged));
  EXPECT_TRUE(usable(MatchStatus::MaxIterations));
  EXPECT_TRUE(usable(MatchStatus::Degenerate));
  EXPECT_FALSE(usable(MatchStatus::NotRun));
  EXPECT_FALSE(usable(MatchStatus::TooFewAssociations));
  EXPECT_FALSE(usable(MatchStatus::NoImprovement));
  EXPECT_FALSE(usable(MatchStatus::InvalidInput));
}

TEST(MatchResult, EveryStatusHasItsName)
{
  EXPECT_STREQ(toString(MatchStatus::NotRun), "NotRun");
  EXPECT_STREQ(toString(MatchStatus::Converged), "Converged");
  EXPECT_STREQ(toString(MatchStatus::MaxIterations), "MaxIterations");
  EXPECT_STREQ(toString(MatchStatus::TooFewAssociations), "TooFewAssociations");
  EXPECT_STREQ(toString(MatchStatus::NoImprovement), "NoImprovement");
  EXPECT_STREQ(toString(MatchStatus::Degenerate), "Degenerate");
  EXPECT_STREQ(toString(MatchStatus::InvalidInput), "InvalidInput");
}

TEST(MatchResult, TheReportIsOneLineWithUnits)
{
  MatchResult result;
  result.status = MatchStatus::Degenerate;
  result.T_ref_cur = {0.82, -0.084, degToRad(8.73)};
  result.covariance = Eigen::Vector3d(4e-6, 9e-6, std::pow(degToRad(0.05), 2)).asDiagonal();
  result.score = 0.97;
  result.associations = 170;
  result.iterations = 7;
  result.times.refinement_s = 0.00125;
  result.unobservableDirection = Eigen::Vector2d(0, 1);
  EXPECT_EQ(result.report(),
            "Degenerate: x 0.8200 m, y -0.0840 m, phi 8.730 deg; sigma 2.0 mm, 3.0 mm, 0.050 deg; "
            "score 0.97, 170 associations, 7 iterations, 1.250 ms; not observable along 90.0 deg");
  result.unobservableDirection.reset();
  result.weakDirection = Eigen::Vector2d(1, 0);
  EXPECT_TRUE(test::says(result.report(), {"weakly observable along 0.0 deg"}));
  result.ambiguity.emplace();
  result.ambiguity->alternatives = 2;
  result.ambiguity->likeliest[0] = {{0.82, 1.916, degToRad(8.73)}, 0.4};
  result.ambiguity->likeliest[1] = {{5, -0.084, degToRad(8.73)}, 0.1};
  EXPECT_TRUE(test::says(result.report(), {"; 2 alternatives"}));
  EXPECT_TRUE(result.ambiguousDirection()->isApprox(Eigen::Vector2d(0, 1)));
  result.guessGivenUp = true;
  EXPECT_TRUE(test::says(result.report(), {"guess given up"}));
  result.headingUnobservable = true;
  EXPECT_TRUE(test::says(result.report(), {"heading not observable"}));
}

TEST(MatchResult, ContradictsTheGuessBeyondThe999PerMilleEllipsoid)
{
  MatchResult result;
  EXPECT_FALSE(result.contradictsGuess()) << "nothing to compare with";
  result.innovation = Innovation{16.2, 3};
  EXPECT_FALSE(result.contradictsGuess());
  result.innovation = Innovation{16.3, 3};
  EXPECT_TRUE(result.contradictsGuess());
  EXPECT_TRUE(test::says(result.report(), {"contradicts the guess, chi2 16.3 of 3"}));
}

TEST(MatchResult, HasNoAmbiguousDirectionWhereOnlyHeadingsDiffer)
{
  MatchResult result;
  EXPECT_FALSE(result.ambiguousDirection().has_value());
  result.ambiguity.emplace();
  result.ambiguity->alternatives = 1;
  result.ambiguity->likeliest[0] = {{0, 0, degToRad(5)}, 0.5};
  EXPECT_FALSE(result.ambiguousDirection().has_value());
}

TEST(MatchResult, TheTotalTimeIsTheSumOfTheStages)
{
  const StageTimes times{1, 2, 4, 8};
  EXPECT_EQ(times.total_s(), 15);
}
}  // namespace psmks
