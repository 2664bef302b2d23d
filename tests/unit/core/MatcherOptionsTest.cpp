/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/core/MatcherOptions.h>

#include <cctype>
#include <set>
#include <sstream>

namespace psmks
{
namespace
{
struct MatcherOptionsTest : testing::Test
{
  MatcherOptions options;
  OptionTable table = optionTable(options);
};

bool endsWith(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

std::set<std::string> fieldsThatDiffer(const OptionTable& a, const OptionTable& b)
{
  std::set<std::string> different;
  for (const OptionField& field : a.fields())
    if (field.get() != b.get(field.section, field.key))
      different.insert(field.section + "." + field.key);
  return different;
}
}  // namespace

TEST_F(MatcherOptionsTest, EachKeyStandsOnceInItsSectionAndSaysWhatItMeans)
{
  std::set<std::string> seen;
  for (const OptionField& field : table.fields())
  {
    EXPECT_TRUE(seen.insert(field.section + "." + field.key).second) << field.key;
    EXPECT_FALSE(field.help.empty()) << field.key;
  }
}

TEST_F(MatcherOptionsTest, EachDefaultIsAcceptedByItsOwnRange)
{
  for (const OptionField& field : table.fields())
    EXPECT_NO_THROW(field.set(field.get())) << field.key;
}

TEST_F(MatcherOptionsTest, DefaultsAndLimitsAreShortNumbers)
{
  const std::size_t longest = 8;  // of what people write: "0.0001"; of what rounding leaves: 17
  for (const OptionField& field : table.fields())
  {
    std::istringstream words(field.get() + " " + field.constraint);
    for (std::string word; words >> word;)
    {
      const bool isNumber = std::isdigit(static_cast<unsigned char>(word[0])) != 0;
      EXPECT_FALSE(isNumber && word.size() > longest) << field.key << ": " << word;
    }
  }
}

TEST_F(MatcherOptionsTest, TheKeyEndsInTheUnitOfItsValue)
{
  for (const OptionField& field : table.fields())
    for (const std::string unit : {"m", "deg", "s"})
      EXPECT_EQ(endsWith(field.key, "_" + unit), endsWith(field.constraint, " " + unit))
          << field.key << ": " << field.constraint;
}

TEST_F(MatcherOptionsTest, ThePaperSchemeIsAnotherSchemeLineFilterAndShortestSegment)
{
  MatcherOptions paper = MatcherOptions::paperScheme();
  EXPECT_EQ(
      fieldsThatDiffer(table, optionTable(paper)),
      (std::set<std::string>{"matcher.scheme", "segmentation.filter", "segmentation.min_rays"}));
}
}  // namespace psmks
