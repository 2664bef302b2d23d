/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/report/WorstPairs.h>
#include <gtest/gtest.h>
#include <tests/unit/report/ScanPairs.h>

namespace psmks
{
using test::matched;

TEST(WorstPairs, AreTheLargestErrorsInOrder)
{
  std::vector<PairRecord> records;
  for (const double error_m : {0.01, 0.05, 0.02, 0.04, 0.03})
    records.push_back(matched(0, error_m));
  EXPECT_EQ(worstRecords(records, 3), (std::vector<std::size_t>{1, 3, 4}));
}

TEST(WorstPairs, OneDegreeCountsAsFiveCentimetres)
{
  const std::vector<PairRecord> records{matched(0, 0.05, 0), matched(1, 0, 1.1),
                                        matched(2, 0.06, 0.1)};
  EXPECT_EQ(worstRecords(records, 3), (std::vector<std::size_t>{2, 1, 0}));
}

TEST(WorstPairs, AreNoMoreThanThereAre)
{
  EXPECT_EQ(worstRecords({matched(0, 1), matched(1, 2)}, 10), (std::vector<std::size_t>{1, 0}));
  EXPECT_TRUE(worstRecords({}, 10).empty());
}
}  // namespace psmks
