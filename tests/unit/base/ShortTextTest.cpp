/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/base/ShortText.h>

namespace psmks
{
TEST(ShortText, OfAShortTextIsTheText)
{
  EXPECT_EQ(shortText(""), "");
  EXPECT_EQ(shortText("max_range_m"), "max_range_m");
  EXPECT_EQ(shortText("Málaga"), "Málaga");
}

TEST(ShortText, OfALongOneIsItsBeginning)
{
  EXPECT_EQ(shortText(std::string(60, 'x')), std::string(60, 'x'));
  EXPECT_EQ(shortText(std::string(200000, 'x')), std::string(60, 'x') + "...");
}

TEST(ShortText, ShowsControlCharactersAsQuestionMarks)
{
  EXPECT_EQ(shortText(std::string_view("a\0b\x1B[31m\n\x7F", 10)), "a?b?[31m??");
}
}  // namespace psmks
