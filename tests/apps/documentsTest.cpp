/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/mrpt/ScanMatcherOptions.h>
#include <tests/support/Program.h>
#include <tests/support/Says.h>

#include <filesystem>
#include <regex>

namespace psmks
{
namespace
{
const std::string kSource = PSMKS_SOURCE_DIR;

std::string source(const std::string& path) { return fileText(kSource + "/" + path); }

std::string quoted(const std::string& path) { return "'" + path + "'"; }

/** Every option of a configuration as ini text. */
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

/** What the first block of C++ in a Markdown text holds. */
std::string cppBlock(const std::string& markdown)
{
  const std::string opening = "```cpp\n";
  const auto begin = markdown.find(opening);
  if (begin == std::string::npos) return "no block of C++";
  const auto end = markdown.find("```", begin + opening.size());
  return markdown.substr(begin + opening.size(), end - begin - opening.size());
}

std::string withoutFirstLine(const std::string& text) { return text.substr(text.find('\n') + 1); }

/** The first thing in a file that the pattern's group matches. */
std::string found(const std::string& path, const std::string& pattern)
{
  const std::string text = source(path);
  std::smatch match;
  return std::regex_search(text, match, std::regex(pattern)) ? match[1].str() : "nothing";
}
}  // namespace

TEST(Config, isWhatTheProgramPrints)
{
  const std::string folder = testing::TempDir() + "psmks_generated";
  const ProgramRun run = runProgram(quoted(kSource + "/scripts/update-config") + " " +
                                    quoted(PSMKS_SLAM) + " " + quoted(folder));
  ASSERT_EQ(run.exitCode, 0) << run.errors;
  for (const char* path : {"config/psmks.ini", "config/psmks-paper.ini", "docs/options.md"})
    EXPECT_EQ(source(path), fileText(folder + "/" + path)) << "run scripts/update-config";
  std::filesystem::remove_all(folder);
}

TEST(Config, loadsIntoTheMatcher)
{
  ScanMatcherOptions paper;
  paper.matcher = MatcherOptions::paperScheme();
  EXPECT_EQ(dumped(loaded("config/psmks.ini")), dumped(ScanMatcherOptions()));
  EXPECT_EQ(dumped(loaded("config/psmks-paper.ini")), dumped(paper));
}

TEST(Readme, showsTheExample)
{
  EXPECT_EQ(cppBlock(source("README.md")),
            withoutFirstLine(source("examples/match_two_scans.cpp")));
}

TEST(Readme, showsWhatTheExamplePrints)
{
  const ProgramRun run = runProgram(quoted(PSMKS_EXAMPLE));
  EXPECT_EQ(run.exitCode, 0) << run.errors;
  const std::string pose = run.output.substr(0, run.output.find(';'));
  EXPECT_TRUE(test::says(source("README.md"), {pose}));
}

/** Rows of its table of options, "| `section.key` | default | allowed | meaning |", stand in the
 * full list as "| `key` | ...". */
TEST(Readme, showsOptionsAsTheyAre)
{
  const std::string readme = source("README.md"), options = source("docs/options.md");
  const std::regex row(R"(\n\| `([a-z]+)\.([a-z_]+)` (\|[^\n]*))");
  int rows = 0;
  for (std::sregex_iterator i(readme.begin(), readme.end(), row), none; i != none; ++i, ++rows)
    EXPECT_TRUE(test::says(options, {"**[" + (*i)[1].str() + "]**",
                                     "| `" + (*i)[2].str() + "` " + (*i)[3].str() + "\n"}));
  EXPECT_GE(rows, 10);
}

TEST(Documents, linkToWhatExists)
{
  const std::regex link(R"(\]\(([^)#:]+)(#[^)]*)?\))");
  for (const char* document : {"README.md", "CONTRIBUTING.md", "config/README.md",
                               "rawlogs/README.md", "docs/architecture.md", "docs/algorithm.md"})
  {
    const std::string text = source(document);
    ASSERT_FALSE(text.empty()) << document;
    const auto folder = std::filesystem::path(kSource + "/" + document).parent_path();
    for (std::sregex_iterator i(text.begin(), text.end(), link), none; i != none; ++i)
      EXPECT_TRUE(std::filesystem::exists(folder / (*i)[1].str())) << document << ": " << (*i)[1];
  }
}

TEST(Documents, agreeOnTheVersion)
{
  EXPECT_EQ(found("package.xml", "<version>(.*)</version>"), PSMKS_VERSION);
  EXPECT_EQ(found("CITATION.cff", "\nversion: (.*)"), PSMKS_VERSION);
}
}  // namespace psmks
