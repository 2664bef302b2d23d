/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/matchers/PairMatcherRegistration.h>
#include <tests/unit/matchers/PairMatcherContract.h>

#include <cmath>

namespace psmks
{
// All matchers that are linked, those of MRPT and of other libraries among them.
INSTANTIATE_TEST_SUITE_P(WithMrpt, PairMatcherContract, testing::ValuesIn(pairMatcherNames()),
                         matcherTestName);

namespace
{
/** How far a matcher ends from the true position in a room, on average over steps to all sides,
 * where the guess is that the robot stood still. */
double meanError_m(const std::string& name)
{
  constexpr int kSteps = 8;
  const BeamGrid grid = BeamGrid::centered(degToRad(270), 541);
  const auto matcher = makePairMatcher(name);
  double sum_m = 0;
  for (int step = 0; step < kSteps; ++step)
  {
    const double direction_rad = 2 * kPi * step / kSteps;
    const Pose2 truth{0.2 * std::cos(direction_rad), 0.2 * std::sin(direction_rad), degToRad(5)};
    const Scan reference = castScan(officeRoom(), {}, grid);
    const Scan current = castScan(officeRoom(), truth, grid);
    const Pose2 found = matcher->match(reference, current, {}).T_ref_cur;
    sum_m += (found.translation() - truth.translation()).norm();
  }
  return sum_m / kSteps;
}

TEST(IcpPairMatcher, WhatIsTunedForAccuracyIsMoreAccurateThanTheDefault)
{
  EXPECT_LT(meanError_m("icp-classic-tuned"), meanError_m("icp-classic"));
  EXPECT_LT(meanError_m("icp-lm-tuned"), meanError_m("icp-lm"));
}
}  // namespace
}  // namespace psmks
