/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */

/** \file
 * The library as a plugin: this program does not link it, and knows psmks by name alone. */

#include <dlfcn.h>
#include <gtest/gtest.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/rtti/CObject.h>
#include <mrpt/slam/CMetricMapsAlignmentAlgorithm.h>
#include <mrpt/system/os.h>

#include <cstdio>
#include <filesystem>
#include <string>

namespace
{
using mrpt::slam::CMetricMapsAlignmentAlgorithm;

const char* const kRawlog =
    "/usr/share/mrpt/datasets/2006-01ENE-21-SENA_Telecom Faculty_one_loop_only.rawlog";

/** Whether clang's sanitizer of addresses is in this program, and so in the library as well. */
#if defined(__has_feature)
constexpr bool kSanitized = __has_feature(address_sanitizer);
#else
constexpr bool kSanitized = false;
#endif

/** Keeps a loaded library, and those that it needs, until the program has ended. One of Ceres's
 * libraries, gflags, frees its registry of flags only if it is asked to, and what a library has
 * left behind is a leak once it is unloaded. */
void neverUnload(const char* library) { dlopen(library, RTLD_LAZY | RTLD_NOLOAD | RTLD_NODELETE); }

/** What a command line prints, errors included. */
std::string printedBy(const std::string& command)
{
  std::string text;
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (!pipe) return text;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text += static_cast<char>(c);
  pclose(pipe);
  return text;
}
}  // namespace

TEST(Plugin, MakesTheMatcherByName)
{
  EXPECT_FALSE(mrpt::rtti::classFactory("psmks::ScanMatcher"));

  std::string errors;
  ASSERT_TRUE(mrpt::system::loadPluginModules(PSMKS_PLUGIN_FILE, errors)) << errors;
  neverUnload(PSMKS_PLUGIN_FILE);
  const auto matcher = std::dynamic_pointer_cast<CMetricMapsAlignmentAlgorithm>(
      mrpt::rtti::classFactory("psmks::ScanMatcher"));
  ASSERT_TRUE(matcher);

  //  . . . . . .
  //  .         .   a room of 4 x 3 m that stays where it is
  //  . . . . . .
  mrpt::maps::CSimplePointsMap map;
  for (float t = 0; t < 1; t += 0.01f)
  {
    map.insertPoint(-2 + 4 * t, -1);
    map.insertPoint(2, -1 + 3 * t);
    map.insertPoint(2 - 4 * t, 2);
    map.insertPoint(-2, 2 - 3 * t);
  }
  const auto pose = matcher->Align(&map, &map, {0.05, 0.05, 0.02});
  EXPECT_NEAR(pose->getMeanVal().x(), 0, 5e-3);
  EXPECT_NEAR(pose->getMeanVal().y(), 0, 5e-3);
  EXPECT_NEAR(pose->getMeanVal().phi(), 0, 2e-3);
}

TEST(Plugin, IsLoadedByRawlogEdit)
{
  if (kSanitized)
    GTEST_SKIP() << "a program without sanitizers cannot load a library that has them";
  if (printedBy("command -v rawlog-edit").empty()) GTEST_SKIP() << "rawlog-edit is not installed";
  if (!std::filesystem::exists(kRawlog)) GTEST_SKIP() << kRawlog << " is not installed";

  const std::string log = std::string("' --info -i '") + kRawlog + "'";
  const std::string loaded = printedBy("rawlog-edit -p '" PSMKS_PLUGIN_FILE + log);
  EXPECT_EQ(loaded.find("Error loading"), std::string::npos) << loaded;
  EXPECT_NE(loaded.find("224"), std::string::npos) << loaded;  // the scans of the log

  const std::string missing = printedBy("rawlog-edit -p '" PSMKS_PLUGIN_FILE ".missing" + log);
  EXPECT_NE(missing.find("Error loading"), std::string::npos) << missing;
}
