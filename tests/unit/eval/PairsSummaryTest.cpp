/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/eval/PairsSummary.h>

#include <cmath>

namespace psmks
{
namespace
{
/** A match that ends `error_m` beside the origin, with sigmas of 1 cm, 1 cm and 0.01 rad. */
PairRecord record(MatchStatus status, double error_m, double time_s)
{
  PairRecord r;
  r.id = 3;
  r.result.status = status;
  r.result.T_ref_cur = {error_m, 0, 0};
  r.result.covariance = 1e-4 * Eigen::Matrix3d::Identity();
  r.time_s = time_s;
  return r;
}

// error      1 cm       2 cm         20 cm      50 cm: corridor   80 cm: stays at the guess
// in sigmas  1          2            20         50                (no say)
const std::vector<PairRecord> kFive{
    record(MatchStatus::Converged, 0.01, 1e-3), record(MatchStatus::MaxIterations, 0.02, 2e-3),
    record(MatchStatus::Converged, 0.20, 3e-3), record(MatchStatus::Degenerate, 0.50, 4e-3),
    record(MatchStatus::NoImprovement, 0.80, 5e-3)};
}  // namespace

TEST(PairsSummary, CountsEveryPairOnce)
{
  const PairsSummary s = summarize(kFive);
  EXPECT_EQ(s.pairs, 5);
  EXPECT_DOUBLE_EQ(s.successShare, 0.4);
  EXPECT_EQ(s.acceptedAndWrong, 1);
  EXPECT_EQ(s.degenerate, 1);
  EXPECT_EQ(s.failed, 1);
}

TEST(PairsSummary, FailedPairsKeepTheErrorOfTheirGuess)
{
  const PairsSummary s = summarize(kFive);
  EXPECT_DOUBLE_EQ(s.translationMedian_m, 0.20);
  EXPECT_NEAR(s.translationP95_m, 0.74, 1e-12);
}

TEST(PairsSummary, ConsistencyIsThatOfUsableMatches)
{
  const PairsSummary s = summarize(kFive);
  EXPECT_NEAR(s.neesMean, (1 + 4 + 400 + 2500) / 4.0, 1e-6);
  EXPECT_DOUBLE_EQ(s.ellipsoidShare, 0.5);
}

TEST(PairsSummary, AMatcherWithoutCovarianceHasNoConsistency)
{
  std::vector<PairRecord> records = kFive;
  for (auto& r : records) r.result.covariance = MatchResult::unknownCovariance();
  EXPECT_TRUE(std::isnan(summarize(records).neesMean));
}

TEST(PairsSummary, TimeRatiosAreThoseOfOneKindOfGuess)
{
  const auto timed = [](double time_s)
  { return std::vector<PairRecord>{record(MatchStatus::Converged, 0, time_s)}; };
  const Table table = pairsTable("",
                                 {{"fast", "zero", timed(1e-3)},
                                  {"slow", "zero", timed(4e-3)},
                                  {"fast", "odometry", timed(1e-3)},
                                  {"slow", "odometry", timed(2e-3)}},
                                 "slow");
  const auto ratio = [&table](std::size_t row) { return std::get<double>(table.rows[row].back()); };
  EXPECT_DOUBLE_EQ(ratio(0), 0.25);
  EXPECT_DOUBLE_EQ(ratio(1), 1);
  EXPECT_DOUBLE_EQ(ratio(2), 0.5);
}

TEST(PairsDump, HasOneRowAPairInTheOrderOfItsHeader)
{
  EXPECT_EQ(dumpHeader(),
            "id,matcher,guess,status,x_m,y_m,phi_deg,sigma_x_m,sigma_y_m,sigma_phi_deg,error_m,"
            "error_deg,time_ms\n");
  const PairsRun run{"psmks", "zero", {record(MatchStatus::Converged, 0.0123456789, 1e-3)}};
  EXPECT_EQ(dumpRows(run),
            "3,psmks,zero,Converged,0.01234568,0,0,0.01,0.01,0.5729578,0.01234568,0,1\n");
}
}  // namespace psmks
