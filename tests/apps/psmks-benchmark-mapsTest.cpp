/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <tests/apps/BenchmarkOnLogs.h>
#include <tests/support/Says.h>

namespace psmks
{
namespace
{
using namespace test;

class PsmksBenchmarkMaps : public BenchmarkOnLogs
{
};
}  // namespace

TEST_F(PsmksBenchmarkMaps, EveryScanButTheFirstIsAlignedToTheMapOfThoseBefore)
{
  const ProgramRun done = run("maps " + log("room") + " --insert-distance_m 0.1");
  ASSERT_EQ(done.exitCode, 0) << done.errors;
  EXPECT_EQ(done.errors, "");
  ASSERT_EQ(rows().size(), 3U);
  EXPECT_EQ(rows()[0].at("aligned_by"), "psmks told");
  EXPECT_EQ(rows()[2].at("aligned_by"), "icp-classic");
  for (const auto& row : rows())
  {
    EXPECT_EQ(row.at("alignments"), kScans - 1);
    EXPECT_GT(row.at("occupied_cells"), 0);
    EXPECT_EQ(row.at("moved"), 0);
  }
  EXPECT_EQ(rows()[0].at("refused"), 0);
}

TEST_F(PsmksBenchmarkMaps, MapsOfPairsAreAlignedByBothAlgorithms)
{
  const ProgramRun done = run("map-pairs rays361 --pairs 5");
  ASSERT_EQ(done.exitCode, 0) << done.errors;
  ASSERT_EQ(rows().size(), 6U);
  EXPECT_EQ(rows()[0].at("maps"), "points to points");
  EXPECT_EQ(rows()[0].at("aligned_by"), "psmks");
  EXPECT_EQ(rows()[0].at("refused"), 0);
  EXPECT_LT(rows()[0].at("error_median_mm"), 10);
  EXPECT_EQ(rows()[4].at("maps"), "grid to grid");
  EXPECT_EQ(rows()[4].at("refused"), 0);
  EXPECT_EQ(rows()[5].at("refused"), 5) << "MRPT's ICP aligns no grids";
  expectUsageError("map-pairs rays361 --cell_m 0", "--cell_m");
  expectUsageError("map-pairs", "SET");
}

TEST_F(PsmksBenchmarkMaps, WhatCannotBeAcceptedSaysWhy)
{
  expectUsageError("maps " + log("room") + " --insert-angle_deg 0", "--insert-angle_deg");
  EXPECT_EQ(run("maps " + log("absent")).exitCode, 2);
}
}  // namespace psmks
