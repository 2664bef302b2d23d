/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/eval/GnuplotCommands.h>
#include <tests/support/Says.h>

namespace psmks
{
TEST(GnuplotCommands, BothAxesOfAMapHaveTicsAtTheSameDistance)
{
  Chart tall;
  tall.equalAspect = true;
  tall.series = {{"way", {{0, 0}, {1, 50}}}};
  EXPECT_TRUE(test::says(gnuplotCommands(tall), {"set xtics 10\n", "set ytics 10\n"}));
}

TEST(GnuplotCommands, CurvesOfTheSameColourDifferByTheirDashes)
{
  Chart many;
  for (int i = 0; i < 8; ++i) many.series.push_back({std::to_string(i), {{0, 0}, {1, 1.0 * i}}});
  const std::string commands = gnuplotCommands(many);
  const auto first = commands.find("#0072b2"), again = commands.find("#0072b2", first + 1);
  ASSERT_NE(again, std::string::npos);
  EXPECT_EQ(commands.find("dashtype"), commands.rfind("dashtype"));
  EXPECT_LT(first, commands.find("dashtype"));
}
}  // namespace psmks
