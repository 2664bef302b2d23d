/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <tests/support/Program.h>
#include <tests/support/Says.h>

namespace psmks
{
TEST(ExampleMrptObservations, PrintsTheMatchAndThePoseWithItsCovariance)
{
  const ProgramRun run = runProgram("'" PSMKS_PROGRAM "'");
  EXPECT_EQ(run.exitCode, 0) << run.errors;
  EXPECT_TRUE(test::says(run.output, {"Converged: x 0.8191 m, y 0.0801 m, phi 9.030 deg",
                                      "Mean: (0.819,0.080,9.03deg)", "Covariance:\n"}));
}
}  // namespace psmks
