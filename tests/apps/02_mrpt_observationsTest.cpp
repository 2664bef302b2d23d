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
  EXPECT_TRUE(test::says(run.output, {"Converged: x 0.8198 m, y 0.0805 m, phi 9.025 deg",
                                      "Mean: (0.820,0.081,9.02deg)", "Covariance:\n"}));
}
}  // namespace psmks
