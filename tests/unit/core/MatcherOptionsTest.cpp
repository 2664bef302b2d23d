/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/core/MatcherOptions.h>
#include <tests/support/Says.h>
#include <tests/support/ThrownText.h>

#include <cctype>
#include <cmath>
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

// What files and flags refuse, code may not set either.
TEST_F(MatcherOptionsTest, ValuesOutOfRangeAreRefusedWithValueAndConstraint)
{
  const auto refusalOf = [](const MatcherOptions& changed)
  { return test::thrownText<OptionError>([&] { changed.validate(); }); };
  MatcherOptions changed;
  EXPECT_NO_THROW(changed.validate());
  changed.joint.confidentScore = 7;
  EXPECT_TRUE(test::says(refusalOf(changed), {"confident_score", "7", "0 to 1"}));
  changed = {};
  changed.joint.distanceGate_m = -1;
  EXPECT_TRUE(test::says(refusalOf(changed), {"distance_gate_m", "-1", "0.001 to 10 m"}));
  changed = {};
  changed.joint.searchAngle_rad = 0;
  EXPECT_TRUE(test::says(refusalOf(changed), {"search_angle_deg", "0", "1 to 180 deg"}));
  changed = {};
  changed.segmentation.rangeSigma_m = std::nan("");
  EXPECT_TRUE(test::says(refusalOf(changed), {"range_sigma_m", "nan"}));
  changed = {};
  changed.scheme = static_cast<Scheme>(2);
  EXPECT_TRUE(test::says(refusalOf(changed), {"scheme", "2", "joint | paper"}));
}

TEST_F(MatcherOptionsTest, ValuesThatDoNotGoTogetherAreRefused)
{
  const auto refusalOf = [](const MatcherOptions& changed)
  { return test::thrownText<OptionError>([&] { changed.validate(); }); };
  MatcherOptions changed;
  changed.preprocessing.minRange_m = 3;
  EXPECT_NO_THROW(changed.validate()) << "a maximum of 0 is none";
  changed.preprocessing.maxRange_m = 2;
  EXPECT_TRUE(test::says(refusalOf(changed), {"max_range_m", "2", "above min_range_m", "3"}));
  changed = {};
  changed.joint.agreedScore = 0.95;
  EXPECT_TRUE(test::says(refusalOf(changed), {"agreed_score", "0.95", "at most confident_score"}));
  changed = {};
  changed.joint.unobservableSigma_m = 0.01;
  EXPECT_TRUE(test::says(refusalOf(changed),
                         {"unobservable_sigma_m", "0.01", "at least weak_direction_sigma_m"}));
}
}  // namespace psmks
