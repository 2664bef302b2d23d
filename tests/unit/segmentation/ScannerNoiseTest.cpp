/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/segmentation/ScannerNoise.h>
#include <psmks/segmentation/Segmentation.h>
#include <tests/support/Scenes.h>

namespace psmks
{
namespace
{
ScannerNoise after(int noisy, int quiet)
{
  ScannerNoise scanner;
  for (int i = 0; i < noisy; ++i) scanner.add(true);
  for (int i = 0; i < quiet; ++i) scanner.add(false);
  return scanner;
}

/** A square room with noise of 3 cm, of which the scan says nothing. */
SegmentedScan segmented(const ScannerNoise& scanner)
{
  constexpr double kReach_m = 30, kSigma_m = 0.03;
  std::mt19937 rng(3);
  const BeamGrid grid = BeamGrid::centered(2 * kPi, 720);
  Scan scan = castScan(squareRoom(), {}, grid, kReach_m, kSigma_m, rng);
  scan.rangeSigma_m = 0;
  SegmentationBuffers buffers;
  SegmentedScan result;
  segmentScan(scan, {}, {}, buffers, result, scanner);
  return result;
}
}  // namespace

TEST(ScannerNoise, ASingleScanIsBelieved) { EXPECT_TRUE(ScannerNoise().isBelieved()); }

TEST(ScannerNoise, IsBelievedWhereNearlyAllScansShowIt)
{
  EXPECT_TRUE(after(3, 1).isBelieved());
  EXPECT_FALSE(after(2, 1).isBelieved());
  EXPECT_FALSE(after(0, 1).isBelieved());
}

TEST(ScannerNoise, LinesOfANoisyScanAreThoseOfANoisyScanner)
{
  const SegmentedScan believed = segmented(ScannerNoise());
  EXPECT_TRUE(believed.showsMoreNoise);
  EXPECT_NEAR(believed.rangeNoise.sigma_m, 0.03, 0.005);
}

TEST(ScannerNoise, WhatAQuietScannersScanShowsIsKeptApart)
{
  const SegmentedScan doubted = segmented(after(1, 9));
  EXPECT_TRUE(doubted.showsMoreNoise);
  EXPECT_DOUBLE_EQ(doubted.rangeNoise.sigma_m, SegmentationOptions().rangeSigma_m);
  EXPECT_NEAR(doubted.shownNoise.sigma_m, 0.03, 0.005);
  EXPECT_NEAR(doubted.shownRangeSigma_m(), 0.03, 0.005);
}
}  // namespace psmks
