/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <tests/support/Program.h>
#include <tests/support/Says.h>

namespace psmks
{
TEST(ExampleTwoScans, FindsTheMotionThatItMadeUp)
{
  const ProgramRun run = runProgram("'" PSMKS_PROGRAM "'");
  EXPECT_EQ(run.exitCode, 0) << run.errors;
  EXPECT_TRUE(
      test::says(run.output, {"Converged: x 0.3000 m, y 0.1000 m, phi 7.000 deg", "score 1.00"}));
}
}  // namespace psmks
