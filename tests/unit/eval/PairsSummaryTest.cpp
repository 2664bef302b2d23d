/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/eval/PairsSummary.h>

#include <cmath>
#include <stdexcept>

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
                                 BoundSummary(), "slow");
  const auto ratio = [&table](std::size_t row) { return std::get<double>(table.rows[row].back()); };
  // Each kind of guess begins with the row of the bound, which has no time.
  EXPECT_TRUE(std::isnan(ratio(0)));
  EXPECT_DOUBLE_EQ(ratio(1), 0.25);
  EXPECT_DOUBLE_EQ(ratio(2), 1);
  EXPECT_TRUE(std::isnan(ratio(3)));
  EXPECT_DOUBLE_EQ(ratio(4), 0.5);
}

TEST(PairsSummary, ErrorsAreHeldAgainstTheBound)
{
  const BoundSummary bound{0.05, 0.12, degToRad(0.01), degToRad(0.03)};
  const Table table = pairsTable("", {{"psmks", "zero", kFive}}, bound, "psmks");
  const auto value = [&table](std::size_t row, const std::string& key)
  {
    for (std::size_t c = 0; c < table.columns.size(); ++c)
      if (table.columns[c].key == key) return std::get<double>(table.rows[row][c]);
    throw std::invalid_argument(key);
  };
  ASSERT_EQ(table.rows.size(), 2U);
  for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
  EXPECT_EQ(std::get<std::string>(table.rows[0][0]), "bound");
  EXPECT_DOUBLE_EQ(value(0, "translation_median_mm"), 50);
  EXPECT_DOUBLE_EQ(value(0, "translation_p95_mm"), 120);
  EXPECT_NEAR(value(0, "rotation_median_deg"), 0.01, 1e-12);
  EXPECT_NEAR(value(0, "rotation_p95_deg"), 0.03, 1e-12);
  EXPECT_TRUE(std::isnan(value(0, "success_percent")));
  EXPECT_DOUBLE_EQ(value(1, "translation_median_to_bound"), 0.20 / 0.05);
  EXPECT_NEAR(value(1, "time_p95_to_median"), 4.8 / 3, 1e-9);
}

TEST(PairsSummary, WithoutABoundThereIsNoRowOfIt)
{
  const Table table = pairsTable("", {{"psmks", "zero", kFive}}, std::nullopt, "psmks");
  ASSERT_EQ(table.rows.size(), 1U);
  EXPECT_EQ(table.rows[0].size(), table.columns.size());
  EXPECT_EQ(std::get<std::string>(table.rows[0][0]), "psmks");
}

TEST(PairsSummary, SuccessesAreCountedWithinTheLimitAskedFor)
{
  const std::vector<PairRecord> records{record(MatchStatus::Converged, 0.04, 1e-3),
                                        record(MatchStatus::Converged, 0.14, 1e-3)};
  EXPECT_DOUBLE_EQ(summarize(records).successShare, 0.5);
  EXPECT_EQ(summarize(records).acceptedAndWrong, 1);
  EXPECT_DOUBLE_EQ(summarize(records, {0.15, degToRad(2)}).successShare, 1);
  EXPECT_EQ(summarize(records, {0.15, degToRad(2)}).acceptedAndWrong, 0);
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
