/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/mrpt/ScanMatcherOptions.h>
#include <tests/support/Program.h>
#include <tests/support/Says.h>
#include <tests/support/ScratchFolder.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iterator>
#include <map>
#include <regex>
#include <sstream>
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

/** The lines of a text without the spaces around them; empty ones are left out. */
std::vector<std::string> trimmedLines(const std::string& text)
{
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in >> std::ws, line);)
    if (!line.empty()) lines.push_back(line);
  return lines;
}

/** Every page that people read. */
std::vector<std::string> documents()
{
  std::vector<std::string> pages = {"README.md",        "CONTRIBUTING.md",   "CHANGELOG.md",
                                    "config/README.md", "rawlogs/README.md", "examples/README.md",
                                    "psmks/README.md"};
  for (const auto& file : std::filesystem::directory_iterator(kSource + "/docs"))
    if (file.path().extension() == ".md")
      pages.push_back("docs/" + file.path().filename().string());
  return pages;
}

/** One row of a table of docs/benchmarks.md, by the names of its columns. */
using BenchmarkRow = std::map<std::string, std::string>;

std::vector<std::string> cellsOf(const std::string& row)
{
  std::vector<std::string> cells;
  const std::regex cell(R"(\|\s*([^|]*[^|\s])\s*(?=\|))");
  for (std::sregex_iterator i(row.begin(), row.end(), cell), none; i != none; ++i)
    cells.push_back((*i)[1]);
  return cells;
}

/** The row that begins with these cells, in the first table below a heading, below a section; empty
 * where there is none. */
BenchmarkRow benchmarkRow(const std::string& section, const std::string& heading,
                          const std::string& firstCells)
{
  const std::string text = source("docs/benchmarks.md");
  const auto begin = text.find("\n### " + heading, text.find("\n## " + section + "\n"));
  const auto end = text.find("\nMeasured on", begin);
  if (begin == std::string::npos) return {};
  std::vector<std::string> names;
  for (const std::string& line : trimmedLines(text.substr(begin, end - begin)))
    if (line.rfind("| matcher", 0) == 0)
      names = cellsOf(line);
    else if (line.rfind("| " + firstCells + " |", 0) == 0)
    {
      BenchmarkRow row;
      const std::vector<std::string> cells = cellsOf(line);
      for (std::size_t i = 0; i < std::min(names.size(), cells.size()); ++i)
        row.emplace(names[i], cells[i]);
      return row;
    }
  return {};
}

/** "29421" as people read it: "29,421". */
std::string withComma(std::string number)
{
  if (number.size() > 3) number.insert(number.size() - 3, ",");
  return number;
}

std::string rounded(const std::string& number, int decimals)
{
  std::ostringstream out;
  out << std::fixed << std::setprecision(decimals) << std::stod("0" + number);
  return out.str();
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
    double minRange_m, maxRange_m, sigma_m, sigmaPerMetre_m;
    BeamTiming beam;
  };
  const std::vector<Scanner> scanners = {{"sick-lms200", 0, 0, 0.01, 0, {0.0133333, degToRad(1)}},
                                         {"sick-lms1xx", 0.5, 20, 0.012, 0, {0.02, 0}},
                                         {"sick-tim5xx", 0.05, 10, 0.02, 0, {0.0666667, 0}},
                                         {"hokuyo-urg-04lx", 0.06, 5.6, 0.008, 0.003, {0.1, 0}},
                                         {"hokuyo-utm-30lx", 0.1, 30, 0.01, 0.001, {0.025, 0}},
                                         {"slamtec-rplidar-a", 0.15, 12, 0.008, 0.002, {0.1, 0}}};
  for (const Scanner& scanner : scanners)
  {
    const ScanMatcherOptions all = loaded("config/sensors/" + scanner.file + ".ini");
    const MatcherOptions& options = all.matcher;
    EXPECT_EQ(all.beam.turn_s, scanner.beam.turn_s) << scanner.file;
    EXPECT_EQ(all.beam.turnIncrement_rad, scanner.beam.turnIncrement_rad) << scanner.file;
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
                         {"\nrange_sigma_m = 0.008\n", "\nrange_sigma_per_metre_m = 0.003\n",
                          "\nmax_range_m = 5.6\n", "\nmin_rays = 6\n"}));
  EXPECT_TRUE(test::says(
      printed("--config " + quoted(config) + " " + sensor),
      {"\nrange_sigma_m = 0.03\n", "\nrange_sigma_per_metre_m = 0.003\n", "\nmin_rays = 7\n"}));
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

/** Every line of the README's block of C++ stands in the example, in the same order. */
TEST(Readme, ShowsLinesOfAnExample)
{
  const std::vector<std::string> shown = trimmedLines(cppBlock(source("README.md")));
  const std::vector<std::string> example = trimmedLines(exampleCode("02_mrpt_observations"));
  EXPECT_EQ(shown.size(), 12U);
  auto at = example.begin();
  for (const std::string& line : shown)
  {
    at = std::find(at, example.end(), line);
    ASSERT_NE(at, example.end()) << line;
  }
}

TEST(Readme, HasAtMost900Words)
{
  std::istringstream text(source("README.md"));
  EXPECT_LE(std::distance(std::istream_iterator<std::string>(text), {}), 900);
}

TEST(Readme, QuotesTheBenchmarksOfPairs)
{
  const std::string readme = source("README.md");
  const std::string all = "all sets without moving objects";
  for (const char* matcher : {"psmks", "icp-classic", "icp-classic-tuned"})
  {
    BenchmarkRow row = benchmarkRow("Harder pairs", all, std::string(matcher) + " | zero");
    EXPECT_TRUE(test::says(readme, {"| " + row["success %"] + " % | " + row["t median mm"] +
                                    " mm | " + row["wrong"] + " | " + row["/ icp-classic"] + " |"}))
        << matcher;
  }
  EXPECT_TRUE(test::says(
      readme, {"| " + benchmarkRow("Harder pairs", all, "bound | zero")["t median mm"] + " mm |"}));
}

TEST(Readme, QuotesTheBenchmarksOfLogs)
{
  const std::string readme = source("README.md");
  for (const char* log : {"fr079", "intel"})
  {
    std::string cells = " |";
    for (const char* reference : {"sequential", "keyframe", "map"})
      cells += ' ' +
               benchmarkRow("Real logs", log, std::string("psmks | ") + reference)["relations m"] +
               " |";
    EXPECT_TRUE(test::says(readme, {cells})) << log;
  }
  for (const char* matcher : {"psmks | map", "icp-classic | map", "guess | sequential"})
    EXPECT_TRUE(test::says(readme, {withComma(benchmarkRow("Real logs", "2006-01ENE-21-SENA",
                                                           matcher)["occupied cells"])}))
        << matcher;
}

TEST(Readme, QuotesTheBenchmarksOfCovariances)
{
  const std::string readme = source("README.md");
  BenchmarkRow simulated =
      benchmarkRow("Scan pairs", "all sets without moving objects", "psmks | zero");
  BenchmarkRow real = benchmarkRow("Steps of a real robot", "csail every 1:", "psmks | odometry");
  EXPECT_TRUE(test::says(readme, {"(NEES) is " + rounded(simulated["NEES"], 1),
                                  "NEES is " + rounded(real["NEES"], 0)}));
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
TEST(ConfigReadme, ShowsOptionsAsTheyAre)
{
  const std::string readme = source("config/README.md"), options = source("docs/options.md");
  const std::regex row(R"(\n\| `([a-z]+)\.([a-z_]+)` (\|[^|\n]+\|[^|\n]+\|[^\n]+\|))");
  int rows = 0;
  for (std::sregex_iterator i(readme.begin(), readme.end(), row), none; i != none; ++i, ++rows)
    EXPECT_TRUE(test::says(options, {"**[" + (*i)[1].str() + "]**",
                                     "| `" + (*i)[2].str() + "` " + (*i)[3].str() + "\n"}));
  EXPECT_GE(rows, 10);
}

TEST(Documents, LinkToWhatExists)
{
  const std::regex link(R"(\]\(([^)#:]+)(#([^)]*))?\))");
  for (const std::string& document : documents())
  {
    const std::string text = source(document);
    ASSERT_FALSE(text.empty()) << document;
    const auto folder = std::filesystem::path(kSource + "/" + document).parent_path();
    for (std::sregex_iterator i(text.begin(), text.end(), link), none; i != none; ++i)
    {
      const std::filesystem::path target = folder / (*i)[1].str();
      EXPECT_TRUE(std::filesystem::exists(target)) << document << ": " << (*i)[1];
      const std::string anchor = (*i)[3];
      if (anchor.empty()) continue;
      EXPECT_TRUE(test::says(fileText(target), {"<a name=\"" + anchor + "\">"})) << document;
    }
  }
}

TEST(Documents, SummariseTheirTables)
{
  const test::ScratchFolder folder;
  for (const char* file : {"benchmarks.md", "experiments.md"})
    std::filesystem::copy_file(kSource + "/docs/" + file, folder.path(file));
  const ProgramRun run =
      runProgram(quoted(kSource + "/scripts/update-summaries") + " " + quoted(folder.path()));
  ASSERT_EQ(run.exitCode, 0) << run.errors;
  for (const char* file : {"benchmarks.md", "experiments.md"})
    EXPECT_EQ(source(std::string("docs/") + file), fileText(folder.path(file)))
        << "run scripts/update-summaries";
}

TEST(Documents, MakeASiteWithoutAWarning)
{
  if (runProgram("doxygen --version").exitCode != 0) GTEST_SKIP() << "doxygen is not installed";
  const test::ScratchFolder folder;
  const ProgramRun run =
      runProgram(quoted(kSource + "/scripts/docs") + " " + quoted(folder.path("docs")));
  EXPECT_EQ(run.exitCode, 0) << run.errors;
  EXPECT_TRUE(std::filesystem::exists(folder.path("docs/html/index.html")));
}

TEST(Documents, AgreeOnTheVersion)
{
  EXPECT_EQ(found("package.xml", "<version>(.*)</version>"), PSMKS_VERSION);
  EXPECT_EQ(found("CITATION.cff", "\nversion: (.*)"), PSMKS_VERSION);
}
}  // namespace psmks
