/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/mrpt/ScanMatcherOptions.h>
#include <tests/support/Program.h>
#include <tests/support/Says.h>
#include <tests/support/ScratchFolder.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <vector>

namespace psmks
{
namespace
{
const std::string kSource = PSMKS_SOURCE_DIR;

/** The log that examples/04_log_to_map reads, of Debian's package mrpt-common. */
const std::string kLogOfExample =
    "/usr/share/mrpt/datasets/2006-01ENE-21-SENA_Telecom Faculty_one_loop_only.rawlog";

std::string source(const std::string& path) { return fileText(kSource + "/" + path); }

std::string quoted(const std::string& path) { return "'" + path + "'"; }

/** All options of a configuration as ini text. */
std::string dumped(const ScanMatcherOptions& options)
{
  std::ostringstream text;
  options.dumpToTextStream(text);
  return text.str();
}

ScanMatcherOptions loaded(const std::string& path)
{
  ScanMatcherOptions options;
  options.loadFromConfigFileName(kSource + "/" + path, "psmks");
  return options;
}

/** The content of the first block of C++ in a Markdown text. */
std::string cppBlock(const std::string& markdown)
{
  const std::string opening = "```cpp\n";
  const auto begin = markdown.find(opening);
  if (begin == std::string::npos) return "no block of C++";
  const auto end = markdown.find("```", begin + opening.size());
  return markdown.substr(begin + opening.size(), end - begin - opening.size());
}

/** An example without its licence and introduction. */
std::string exampleCode(const std::string& name)
{
  const std::string text = source("examples/" + name + ".cpp");
  return text.substr(std::min(text.size(), text.find("#include")));
}

/** The times of matches, which differ from run to run, replaced by a sign. */
std::string withoutTimes(const std::string& text)
{
  return std::regex_replace(text, std::regex("[0-9.]+ ms"), "# ms");
}

/** The first text in a file that the group of the pattern matches. */
std::string found(const std::string& path, const std::string& pattern)
{
  const std::string text = source(path);
  std::smatch match;
  return std::regex_search(text, match, std::regex(pattern)) ? match[1].str() : "nothing";
}
}  // namespace

TEST(Config, IsWhatTheProgramPrints)
{
  const test::ScratchFolder folder;
  const ProgramRun run = runProgram(quoted(kSource + "/scripts/update-config") + " " +
                                    quoted(PSMKS_SLAM) + " " + quoted(folder.path()));
  ASSERT_EQ(run.exitCode, 0) << run.errors;
  for (const char* path : {"config/psmks.ini", "config/psmks-paper.ini", "docs/options.md"})
    EXPECT_EQ(source(path), fileText(folder.path(path))) << "run scripts/update-config";
}

TEST(Config, LoadsIntoTheMatcher)
{
  ScanMatcherOptions paper;
  paper.matcher = MatcherOptions::paperScheme();
  EXPECT_EQ(dumped(loaded("config/psmks.ini")), dumped(ScanMatcherOptions()));
  EXPECT_EQ(dumped(loaded("config/psmks-paper.ini")), dumped(paper));
}

TEST(SensorFiles, HoldWhatTheirTableSays)
{
  struct Scanner
  {
    std::string file;
    double minRange_m, maxRange_m, sigma_m, sigmaPerMetre_m, beamTurn_s;
  };
  const std::vector<Scanner> scanners = {{"sick-lms200", 0, 0, 0.01, 0, 0.0133333},
                                         {"sick-lms1xx", 0.5, 20, 0.012, 0, 0.02},
                                         {"sick-tim5xx", 0.05, 10, 0.02, 0, 0.0666667},
                                         {"hokuyo-urg-04lx", 0.06, 5.6, 0.005, 0.01, 0.1},
                                         {"hokuyo-utm-30lx", 0.1, 30, 0.01, 0.001, 0.025},
                                         {"slamtec-rplidar-a", 0.15, 12, 0.005, 0.01, 0.1}};
  for (const Scanner& scanner : scanners)
  {
    const ScanMatcherOptions all = loaded("config/sensors/" + scanner.file + ".ini");
    const MatcherOptions& options = all.matcher;
    EXPECT_EQ(all.beamTurn_s, scanner.beamTurn_s) << scanner.file;
    EXPECT_EQ(options.preprocessing.minRange_m, scanner.minRange_m) << scanner.file;
    EXPECT_EQ(options.preprocessing.maxRange_m, scanner.maxRange_m) << scanner.file;
    EXPECT_EQ(options.segmentation.rangeSigma_m, scanner.sigma_m) << scanner.file;
    EXPECT_EQ(options.segmentation.rangeSigmaPerMetre_m, scanner.sigmaPerMetre_m) << scanner.file;
    EXPECT_TRUE(test::says(source("config/README.md"), {"`" + scanner.file + ".ini`"}));
  }
  const std::filesystem::directory_iterator files(kSource + "/config/sensors"), none;
  EXPECT_EQ(static_cast<std::size_t>(std::distance(files, none)), scanners.size());
}

/** Defaults, --sensor-file, --config, --set: each overrides those before it. */
TEST(SensorFiles, OverrideDefaultsAndAreOverridden)
{
  const test::ScratchFolder folder;
  const std::string config = folder.path("over_sensor.ini");
  std::ofstream(config) << "[psmks.segmentation]\nrange_sigma_m = 0.03\nmin_rays = 7\n";
  const auto printed = [&](const std::string& flags)
  {
    const ProgramRun run = runProgram(quoted(PSMKS_SLAM) + " --print-config " + flags);
    EXPECT_EQ(run.exitCode, 0) << run.errors;
    return run.output;
  };
  const std::string sensor =
      "--sensor-file " + quoted(kSource + "/config/sensors/hokuyo-urg-04lx.ini");
  EXPECT_TRUE(test::says(printed(sensor),
                         {"\nrange_sigma_m = 0.005\n", "\nrange_sigma_per_metre_m = 0.01\n",
                          "\nmax_range_m = 5.6\n", "\nmin_rays = 6\n"}));
  EXPECT_TRUE(test::says(
      printed("--config " + quoted(config) + " " + sensor),
      {"\nrange_sigma_m = 0.03\n", "\nrange_sigma_per_metre_m = 0.01\n", "\nmin_rays = 7\n"}));
  EXPECT_TRUE(
      test::says(printed(sensor + " --set segmentation.min_rays=8 --config " + quoted(config)),
                 {"\nrange_sigma_m = 0.03\n", "\nmin_rays = 8\n"}));
}

TEST(SensorFiles, ThatAreMissingAreAnErrorOfUse)
{
  const ProgramRun run = runProgram(quoted(PSMKS_SLAM) + " --print-config --sensor-file none.ini");
  EXPECT_EQ(run.exitCode, 1);
  EXPECT_TRUE(test::says(run.errors, {"none.ini"}));
}

TEST(Readme, ShowsAnExample)
{
  EXPECT_EQ(cppBlock(source("README.md")), exampleCode("02_mrpt_observations"));
}

TEST(Readme, ShowsWhatTheExamplePrints)
{
  const ProgramRun run = runProgram(quoted(PSMKS_EXAMPLES "/02_mrpt_observations"));
  EXPECT_EQ(run.exitCode, 0) << run.errors;
  const std::string pose = run.output.substr(0, run.output.find(';'));
  EXPECT_TRUE(test::says(source("README.md"), {pose}));
}

TEST(Examples, AreShownWithWhatTheyPrint)
{
  if (!std::filesystem::exists(kLogOfExample)) GTEST_SKIP() << kLogOfExample << " is missing";
  const test::ScratchFolder folder;
  const std::string written = folder.path("README.md");
  const ProgramRun run = runProgram(quoted(kSource + "/scripts/update-examples") + " " +
                                    quoted(PSMKS_EXAMPLES) + " " + quoted(written));
  ASSERT_EQ(run.exitCode, 0) << run.errors;
  EXPECT_EQ(withoutTimes(source("examples/README.md")), withoutTimes(fileText(written)))
      << "run scripts/update-examples";
}

/** Rows of its table of options, "| `section.key` | default | allowed | meaning |", stand in the
 * full list as "| `key` | ...". */
TEST(Readme, ShowsOptionsAsTheyAre)
{
  const std::string readme = source("README.md"), options = source("docs/options.md");
  const std::regex row(R"(\n\| `([a-z]+)\.([a-z_]+)` (\|[^\n]*))");
  int rows = 0;
  for (std::sregex_iterator i(readme.begin(), readme.end(), row), none; i != none; ++i, ++rows)
    EXPECT_TRUE(test::says(options, {"**[" + (*i)[1].str() + "]**",
                                     "| `" + (*i)[2].str() + "` " + (*i)[3].str() + "\n"}));
  EXPECT_GE(rows, 10);
}

TEST(Documents, LinkToWhatExists)
{
  const std::regex link(R"(\]\(([^)#:]+)(#[^)]*)?\))");
  for (const char* document :
       {"README.md", "CONTRIBUTING.md", "config/README.md", "rawlogs/README.md",
        "examples/README.md", "docs/architecture.md", "docs/algorithm.md"})
  {
    const std::string text = source(document);
    ASSERT_FALSE(text.empty()) << document;
    const auto folder = std::filesystem::path(kSource + "/" + document).parent_path();
    for (std::sregex_iterator i(text.begin(), text.end(), link), none; i != none; ++i)
      EXPECT_TRUE(std::filesystem::exists(folder / (*i)[1].str())) << document << ": " << (*i)[1];
  }
}

TEST(Documents, AgreeOnTheVersion)
{
  EXPECT_EQ(found("package.xml", "<version>(.*)</version>"), PSMKS_VERSION);
  EXPECT_EQ(found("CITATION.cff", "\nversion: (.*)"), PSMKS_VERSION);
}
}  // namespace psmks
