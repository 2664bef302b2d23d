/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/base/NumberRow.h>

namespace psmks
{
namespace
{
using Numbers = std::vector<double>;

TEST(NumberRow, BlanksTabsAndCarriageReturnsSeparateNumbers)
{
  EXPECT_EQ(parseNumberRow("1 -2.5\t3e-2  4\r"), (Numbers{1, -2.5, 0.03, 4}));
}

TEST(NumberRow, ABlankLineHasNoNumbers)
{
  EXPECT_EQ(parseNumberRow(""), Numbers());
  EXPECT_EQ(parseNumberRow(" \t\r"), Numbers());
}

TEST(NumberRow, OneWordThatIsNoFiniteNumberSpoilsTheRow)
{
  for (const char* row : {"1 2 x", "1 2x", "1,5", "1 nan", "inf 1", "1e999", "+1", "0x10", "1 2 #"})
    EXPECT_EQ(parseNumberRow(row), std::nullopt) << row;
}
}  // namespace
}  // namespace psmks
