/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/base/OptionTable.h>
#include <psmks/geometry/Angle.h>
#include <tests/support/RandomNumbers.h>
#include <tests/support/Says.h>
#include <tests/support/ThrownText.h>

#include <cmath>
#include <limits>
#include <locale>

namespace psmks
{
namespace
{
enum class Shape
{
  Round,
  Square
};

struct RobotOptions
{
  double radius_m = 0.25;
  double turn_rad = degToRad(30);
  int wheels = 3;
  bool loud = false;
  Shape shape = Shape::Square;
  std::string name = "Rhino";
};

struct Robot : testing::Test
{
  Robot()
  {
    table.beginSection("robot", "A machine on wheels.");
    table.add("radius_m", options.radius_m, Unit::Metre, 0, 2, "of the body");
    table.add("turn_deg", options.turn_rad, Unit::Degree, degToRad(-180), degToRad(180),
              "per step");
    table.add("wheels", options.wheels, 2, 8, "that touch the floor");
    table.add("loud", options.loud, "beeps");
    table.add("shape", options.shape, {"round", "square"}, "of the body");
    table.add("name", options.name, "painted on it");
  }

  void set(const std::string& key, const std::string& value) { table.set("robot", key, value); }

  std::string refusalOf(const std::string& key, const std::string& value)
  {
    return test::thrownText<OptionError>([&] { set(key, value); });
  }

  RobotOptions options;
  OptionTable table;
};

using OptionTableTest = Robot;

/** Writes numbers with a decimal comma, as many locales do: 0,5. */
struct DecimalComma : std::numpunct<char>
{
  char do_decimal_point() const override { return ','; }
};
}  // namespace

TEST_F(OptionTableTest, ATextReachesTheStruct)
{
  set("radius_m", "0.5");
  set("turn_deg", " -45 ");
  set("wheels", "4");
  set("loud", "true");
  set("shape", "round");
  set("name", " B21 r ");
  EXPECT_EQ(options.radius_m, 0.5);
  EXPECT_EQ(options.turn_rad, degToRad(-45));
  EXPECT_EQ(options.wheels, 4);
  EXPECT_TRUE(options.loud);
  EXPECT_EQ(options.shape, Shape::Round);
  EXPECT_EQ(options.name, "B21 r");
}

TEST_F(OptionTableTest, ValuesAreWrittenAsPeopleWriteThem)
{
  EXPECT_EQ(table.get("robot", "radius_m"), "0.25");
  EXPECT_EQ(table.get("robot", "turn_deg"), "30");
  EXPECT_EQ(table.get("robot", "wheels"), "3");
  EXPECT_EQ(table.get("robot", "loud"), "false");
  EXPECT_EQ(table.get("robot", "shape"), "square");
}

TEST_F(OptionTableTest, EveryWholeDegreeIsWrittenWhole)
{
  for (int angle_deg = -180; angle_deg <= 180; ++angle_deg)
  {
    options.turn_rad = degToRad(angle_deg);
    EXPECT_EQ(table.get("robot", "turn_deg"), std::to_string(angle_deg));
  }
}

TEST_F(OptionTableTest, ANumberSurvivesItsTextBitByBit)
{
  test::RandomNumbers random(41);
  SCOPED_TRACE(random.seedText());
  for (int n = 0; n < 5000; ++n)
  {
    const double turn_rad = random.uniform(-kPi, kPi), radius_m = random.uniform(0, 2);
    options.turn_rad = turn_rad;
    options.radius_m = radius_m;
    const std::string turn = table.get("robot", "turn_deg"),
                      radius = table.get("robot", "radius_m");
    options.turn_rad = options.radius_m = 0;
    set("turn_deg", turn);
    set("radius_m", radius);
    ASSERT_EQ(options.turn_rad, turn_rad) << turn;
    ASSERT_EQ(options.radius_m, radius_m) << radius;
  }
}

TEST_F(OptionTableTest, TheEndsOfARangeBelongToIt)
{
  set("turn_deg", "180");
  EXPECT_EQ(options.turn_rad, kPi);
  set("turn_deg", "-180");
  set("radius_m", "0");
  set("radius_m", "2");
  set("wheels", "8");
  EXPECT_EQ(options.wheels, 8);
}

TEST_F(OptionTableTest, AnUnknownKeyNamesTheNearestOne)
{
  EXPECT_TRUE(
      test::says(refusalOf("radus_m", "1"), {"'radus_m'", "'robot'", "did you mean 'radius_m'"}));
  EXPECT_TRUE(test::says(refusalOf("wheel", "4"), {"did you mean 'wheels'"}));
}

TEST_F(OptionTableTest, AnUnknownSectionIsNamed)
{
  const auto refusal = test::thrownText<OptionError>([&] { table.set("rebot", "wheels", "4"); });
  EXPECT_TRUE(test::says(refusal, {"'rebot'"}));
  EXPECT_THROW(table.get("rebot", "wheels"), OptionError);
}

TEST_F(OptionTableTest, AValueOutOfRangeIsRefusedWithKeyValueAndRange)
{
  EXPECT_TRUE(test::says(refusalOf("radius_m", "2.5"), {"'radius_m'", "'2.5'", "0 to 2 m"}));
  EXPECT_TRUE(test::says(refusalOf("turn_deg", "181"), {"'turn_deg'", "'181'", "-180 to 180 deg"}));
  EXPECT_TRUE(test::says(refusalOf("wheels", "9"), {"'wheels'", "'9'", "2 to 8"}));
}

TEST_F(OptionTableTest, WhatIsNoValueIsRefusedWithKeyTextAndConstraint)
{
  for (const char* text : {"", "much", "1.5 m", "1,5", "0.5x", "nan", "inf", "1e999", "--1"})
    EXPECT_TRUE(test::says(refusalOf("radius_m", text),
                           {"'radius_m'", "0 to 2 m", "'" + std::string(text) + "'"}));
  for (const char* text : {"", "four", "4.0", "4 5", "99999999999999999999"})
    EXPECT_TRUE(test::says(refusalOf("wheels", text),
                           {"'wheels'", "2 to 8", "'" + std::string(text) + "'"}));
  EXPECT_TRUE(test::says(refusalOf("loud", "1"), {"'loud'", "'1'", "true | false"}));
  EXPECT_TRUE(test::says(refusalOf("shape", "oval"), {"'shape'", "'oval'", "round | square"}));
}

TEST_F(OptionTableTest, ARefusedValueChangesNothing)
{
  for (const char* text : {"9", "many"}) refusalOf("wheels", text);
  refusalOf("radius_m", "7");
  EXPECT_EQ(options.wheels, 3);
  EXPECT_EQ(options.radius_m, 0.25);
}

TEST_F(OptionTableTest, TheIniTextExplainsAndSetsEveryField)
{
  const std::string ini = table.toIni("demo_");
  EXPECT_TRUE(test::says(
      ini, {"# A machine on wheels.\n[demo_robot]\n", "# of the body (0 to 2 m)\nradius_m = 0.25\n",
            "# per step (-180 to 180 deg)\nturn_deg = 30\n",
            "# of the body (round | square)\nshape = square\n"}));
}

TEST_F(OptionTableTest, TheMarkdownTableHasARowForEveryField)
{
  const std::string table_md = table.toMarkdown();
  EXPECT_TRUE(test::says(table_md, {"**[robot]** A machine on wheels.\n",
                                    "| `radius_m` | 0.25 | 0 to 2 m | of the body |\n",
                                    "| `loud` | false | true \\| false | beeps |\n",
                                    "| `shape` | square | round \\| square | of the body |\n"}));
}

TEST_F(OptionTableTest, ALocaleWithADecimalCommaChangesNothing)
{
  const std::locale before = std::locale::global(std::locale(std::locale(), new DecimalComma));
  const std::string radius = table.get("robot", "radius_m");
  set("radius_m", "1.5");
  std::locale::global(before);
  EXPECT_EQ(radius, "0.25");
  EXPECT_EQ(options.radius_m, 1.5);
}

TEST_F(Robot, ValuesThatCodeWroteAreHeldAgainstTheSameConstraints)
{
  EXPECT_NO_THROW(table.validate());
  const auto refusal = [this]
  { return test::thrownText<OptionError>([this] { table.validate(); }); };
  options.radius_m = 2.5;
  EXPECT_TRUE(test::says(refusal(), {"radius_m", "2.5", "0 to 2 m"}));
  options.radius_m = std::nan("");
  EXPECT_TRUE(test::says(refusal(), {"radius_m", "nan", "0 to 2 m"}));
  options.radius_m = -std::numeric_limits<double>::infinity();
  EXPECT_TRUE(test::says(refusal(), {"radius_m", "-inf", "0 to 2 m"}));
  options.radius_m = 2;
  options.wheels = 9;
  EXPECT_TRUE(test::says(refusal(), {"wheels", "9", "2 to 8"}));
  options.wheels = 8;
  options.shape = static_cast<Shape>(7);
  EXPECT_TRUE(test::says(refusal(), {"shape", "7", "round | square"}));
}
}  // namespace psmks
