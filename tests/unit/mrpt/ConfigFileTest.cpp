/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <mrpt/config/CConfigFile.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <psmks/geometry/Angle.h>
#include <psmks/mrpt/ConfigFile.h>
#include <tests/support/Program.h>
#include <tests/support/Says.h>
#include <tests/support/ScratchFolder.h>
#include <tests/support/ThrownText.h>

namespace psmks::test
{
using mrpt::config::CConfigFile;
using mrpt::config::CConfigFileMemory;

namespace
{
/** Options of two stages, as a robot might have them. */
struct RobotOptions
{
  double length_m = 0.5;
  double turn_rad = degToRad(30);
  int wheels = 4;
  bool brakes = true;
};

OptionTable tableOf(RobotOptions& options)
{
  OptionTable table;
  table.beginSection("body", "What it is made of.");
  table.add("length_m", options.length_m, Unit::Metre, 0.1, 2, "from end to end");
  table.add("wheels", options.wheels, 2, 8, "that it stands on");
  table.beginSection("drive", "How it moves.");
  table.add("turn_deg", options.turn_rad, Unit::Degree, 0, degToRad(90), "in a second");
  table.add("brakes", options.brakes, "whether it can stop");
  return table;
}

/** The options after a file with this text was read for the section "robot". */
RobotOptions loaded(const std::string& ini)
{
  RobotOptions options;
  OptionTable table = tableOf(options);
  loadOptions(table, CConfigFileMemory(ini), "robot");
  return options;
}

std::string loadingError(const std::string& ini)
{
  return thrownText<OptionError>([&] { loaded(ini); });
}

/** Numbers without a short decimal form. */
RobotOptions unevenOptions() { return {1.0 / 3, 0.1, 3, false}; }

void expectSame(const RobotOptions& actual, const RobotOptions& expected)
{
  EXPECT_EQ(actual.length_m, expected.length_m);
  EXPECT_EQ(actual.turn_rad, expected.turn_rad);
  EXPECT_EQ(actual.wheels, expected.wheels);
  EXPECT_EQ(actual.brakes, expected.brakes);
}
}  // namespace

TEST(ConfigFile, ReadsEachStageFromASectionOfItsOwn)
{
  const RobotOptions options = loaded(
      "[robot.body]\n"
      "length_m = 0.75  // a comment\n"
      "[robot.drive]\n"
      "turn_deg = 45\n"
      "brakes = false\n");
  EXPECT_EQ(options.length_m, 0.75);
  EXPECT_EQ(options.turn_rad, degToRad(45));
  EXPECT_FALSE(options.brakes);
}

TEST(ConfigFile, KeepsWhatTheFileDoesNotName)
{
  const RobotOptions options = loaded("[robot.body]\nlength_m = 1\n");
  EXPECT_EQ(options.wheels, RobotOptions().wheels);
  EXPECT_EQ(options.turn_rad, RobotOptions().turn_rad);
}

TEST(ConfigFile, LeavesForeignSectionsAlone)
{
  for (const char* ini : {"", "[ICP]\nmaxIterations = 80\n", "[robots.body]\nlength_m = 9\n",
                          "[body]\nlength_m = 9\n"})
    expectSame(loaded(ini), RobotOptions());
}

TEST(ConfigFile, NamesAnUnknownSection)
{
  EXPECT_TRUE(says(loadingError("[robot.bodi]\nwheels = 3\n"), {"[robot.bodi]", "bodi"}));
}

TEST(ConfigFile, NamesAnUnknownKeyAndTheNearestOne)
{
  EXPECT_TRUE(
      says(loadingError("[robot.body]\nwheel = 3\n"), {"robot.body", "'wheel'", "'wheels'"}));
  EXPECT_TRUE(says(loadingError("[robot.drive]\nwheels = 3\n"), {"robot.drive", "'wheels'"}))
      << "a key of another stage";
}

TEST(ConfigFile, SaysWhereOptionsOutsideOfAStageBelong)
{
  EXPECT_TRUE(
      says(loadingError("[robot]\nwheels = 3\n"), {"[robot]", "'wheels'", "[robot.<stage>]"}));
}

TEST(ConfigFile, QuotesAValueThatIsNoneAndWhatIsAllowed)
{
  EXPECT_TRUE(says(loadingError("[robot.body]\nwheels = many\n"), {"wheels", "many", "2 to 8"}));
  EXPECT_TRUE(says(loadingError("[robot.body]\nwheels =\n"), {"wheels", "2 to 8"}));
  EXPECT_TRUE(says(loadingError("[robot.body]\nlength_m = 3\n"), {"length_m", "3", "0.1 to 2 m"}));
  EXPECT_TRUE(says(loadingError("[robot.drive]\nturn_deg = 91\n"), {"turn_deg", "91", "90 deg"}));
  EXPECT_TRUE(says(loadingError("[robot.drive]\nbrakes = perhaps\n"), {"brakes", "perhaps"}));
}

TEST(ConfigFile, HasSetWhatStoodBeforeAnError)
{
  RobotOptions options;
  OptionTable table = tableOf(options);
  const CConfigFileMemory file(
      std::string("[robot.body]\nlength_m = 1\n[robot.drive]\nturn_deg = none\n"));
  EXPECT_THROW(loadOptions(table, file, "robot"), OptionError);
  EXPECT_EQ(options.length_m, 1);
  EXPECT_EQ(options.turn_rad, RobotOptions().turn_rad);
}

// MRPT takes a file that does not exist as one without sections.
TEST(ConfigFile, ThatIsMissingSetsNothing)
{
  const ScratchFolder folder;
  const CConfigFile missing(folder.path("missing.ini"));
  RobotOptions options = unevenOptions();
  OptionTable table = tableOf(options);
  loadOptions(table, missing, "robot");
  expectSame(options, unevenOptions());
}

TEST(ConfigFile, GivesBackFromAFileWhatWasSavedToTheLastBit)
{
  const ScratchFolder folder;
  const std::string path = folder.path("robot.ini");
  RobotOptions saved = unevenOptions(), options;
  {
    CConfigFile file(path);
    saveOptions(tableOf(saved), file, "robot");
  }
  EXPECT_TRUE(says(fileText(path), {"[robot.body]", "wheels", "[robot.drive]", "turn_deg"}));
  OptionTable table = tableOf(options);
  loadOptions(table, CConfigFile(path), "robot");
  expectSame(options, saved);
}

TEST(ConfigFile, GivesBackFromMemoryWhatWasSavedToTheLastBit)
{
  RobotOptions saved = unevenOptions(), options;
  CConfigFileMemory memory;
  saveOptions(tableOf(saved), memory, "robot");
  OptionTable table = tableOf(options);
  loadOptions(table, memory, "robot");
  expectSame(options, saved);
}
}  // namespace psmks::test
