/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <mrpt/config/CConfigFile.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <psmks/mrpt/ScanMatcherOptions.h>
#include <tests/support/Says.h>
#include <tests/support/ScratchFolder.h>
#include <tests/support/ThrownText.h>

#include <map>
#include <sstream>

namespace psmks::test
{
using mrpt::config::CConfigFile;
using mrpt::config::CConfigFileMemory;

namespace
{
using Values = std::map<std::string, std::string>;

Values valuesOf(const ScanMatcherOptions& options)
{
  ScanMatcherOptions copy = options;
  Values values;
  const OptionTable table = optionTable(copy);
  for (const OptionField& field : table.fields())
    values[field.section + "." + field.key] = field.get();
  return values;
}

/** Numbers with no short decimal form, in metres, in degrees and without a unit. */
ScanMatcherOptions unevenOptions()
{
  ScanMatcherOptions options;
  options.matcher.scheme = Scheme::Paper;
  options.matcher.segmentation.rangeSigma_m = 0.1 / 3;
  options.matcher.joint.searchAngle_rad = 1.0 / 3;
  options.matcher.paper.maxIterations = 17;
  options.matcher.paper.mahalanobisGate = 3.0000000000000004;
  options.view.fieldOfView_rad = 4.1;
  options.view.T_map_sensor = {0.78, -0.1 / 3, 0.7};
  options.maxTilt_rad = 0.1;
  options.thresholdDist = 1.0 / 3;
  options.guessSigma_rad = 0.01;
  return options;
}

std::string loadingError(const std::string& ini)
{
  return thrownText<OptionError>(
      [&]
      {
        ScanMatcherOptions options;
        options.loadFromConfigFile(CConfigFileMemory(ini), "psmks");
      });
}
}  // namespace

TEST(ScanMatcherOptions, SurvivesAFileExactly)
{
  const ScratchFolder folder;
  const std::string file = folder.path("options.ini");
  unevenOptions().saveToConfigFileName(file, "psmks");
  ScanMatcherOptions loaded;
  loaded.loadFromConfigFileName(file, "psmks");

  EXPECT_EQ(valuesOf(loaded), valuesOf(unevenOptions()));
  EXPECT_EQ(loaded.matcher.segmentation.rangeSigma_m, 0.1 / 3);
  EXPECT_EQ(loaded.matcher.joint.searchAngle_rad, 1.0 / 3);
  EXPECT_EQ(loaded.view.T_map_sensor.phi_rad, 0.7);
}

TEST(ScanMatcherOptions, SurvivesMemoryExactly)
{
  CConfigFileMemory memory;
  unevenOptions().saveToConfigFile(memory, "a");
  ScanMatcherOptions loaded;
  loaded.loadFromConfigFile(memory, "a");
  EXPECT_EQ(valuesOf(loaded), valuesOf(unevenOptions()));
}

TEST(ScanMatcherOptions, PrintsEveryOptionSoThatItCanBeLoaded)
{
  std::ostringstream out;
  unevenOptions().dumpToTextStream(out);
  EXPECT_TRUE(says(out.str(), {"[psmks.view]", "sensor_phi_deg", "[psmks.segmentation]"}));

  ScanMatcherOptions loaded;
  loaded.loadFromConfigFile(CConfigFileMemory(out.str()), "psmks");
  EXPECT_EQ(valuesOf(loaded), valuesOf(unevenOptions()));
}

TEST(ScanMatcherOptions, KeepsWhatTheFileDoesNotName)
{
  ScanMatcherOptions options = unevenOptions();
  options.loadFromConfigFile(CConfigFileMemory("[psmks.view]\n"
                                               "rays = 360  // one a degree\n"
                                               "[ICP]\n"
                                               "maxIterations = 80\n"),
                             "psmks");
  Values expected = valuesOf(unevenOptions());
  expected["view.rays"] = "360";
  EXPECT_EQ(valuesOf(options), expected);
}

TEST(ScanMatcherOptions, RefusesWhatItDoesNotKnow)
{
  EXPECT_TRUE(says(loadingError("[psmks.view]\nray = 360\n"), {"psmks.view", "'ray'", "'rays'"}));
  EXPECT_TRUE(says(loadingError("[psmks.vew]\nrays = 360\n"), {"psmks.vew", "vew"}));
  EXPECT_TRUE(says(loadingError("[PSMKS.vew]\nrays = 360\n"), {"vew"}));
  EXPECT_TRUE(says(loadingError("[psmks]\nrays = 360\n"), {"[psmks]", "rays", "<stage>"}));
}

TEST(ScanMatcherOptions, RefusesValuesThatAreNone)
{
  EXPECT_TRUE(says(loadingError("[psmks.view]\nrays = abc\n"), {"rays", "abc", "2 to 100000"}));
  EXPECT_TRUE(says(loadingError("[psmks.view]\nrays =\n"), {"rays", "2 to 100000"}));
  EXPECT_TRUE(says(loadingError("[psmks.view]\nrays = 1\n"), {"rays", "1", "2 to 100000"}));
  EXPECT_TRUE(says(loadingError("[psmks.mounting]\nmax_tilt_deg = 60\n"),
                   {"max_tilt_deg", "60", "45 deg"}));
  EXPECT_TRUE(says(loadingError("[psmks.matcher]\nscheme = icp\n"), {"scheme", "icp", "joint"}));
}

TEST(ScanMatcherOptions, RefusesAFileThatIsNotThereOrHasNoSuchSection)
{
  const ScratchFolder folder;
  ScanMatcherOptions options;
  EXPECT_TRUE(says(thrownText<OptionError>(
                       [&] { options.loadFromConfigFileName(folder.path("none.ini"), "psmks"); }),
                   {"none.ini", "exist"}));
  const std::string file = folder.path("options.ini");
  unevenOptions().saveToConfigFileName(file, "psmks");
  EXPECT_TRUE(says(thrownText<OptionError>([&] { options.loadFromConfigFileName(file, "psmsk"); }),
                   {"options.ini", "[psmsk.<stage>]"}));
  EXPECT_EQ(valuesOf(options), valuesOf(ScanMatcherOptions()));
}

TEST(ScanMatcherOptions, ChangesNothingWhenTheFileIsRefused)
{
  ScanMatcherOptions options;
  const CConfigFileMemory file(
      std::string("[psmks.matcher]\nscheme = paper\n[psmks.view]\nrays = abc\n"));
  EXPECT_THROW(options.loadFromConfigFile(file, "psmks"), OptionError);
  EXPECT_EQ(valuesOf(options), valuesOf(ScanMatcherOptions()));
}
}  // namespace psmks::test
