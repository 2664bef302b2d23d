/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/gzip/GzipLines.h>
#include <tests/support/ScratchFolder.h>

#include <fstream>

namespace psmks
{
namespace
{
using Lines = std::vector<std::string>;

class GzipLinesTest : public testing::Test
{
 protected:
  Lines read(const std::string& text) const
  {
    std::ofstream(path_, std::ios::binary) << text;
    GzipLines lines(path_);
    Lines result;
    for (std::string_view line; lines.next(line);)
    {
      result.emplace_back(line);
      EXPECT_EQ(lines.number(), static_cast<int>(result.size()));
    }
    return result;
  }

  const test::ScratchFolder folder_;
  const std::string path_ = folder_.path("text");
};

TEST_F(GzipLinesTest, ComeWithoutTheirEndsAndTheLastOneNeedsNone)
{
  EXPECT_EQ(read("a\n\nb c\n"), (Lines{"a", "", "b c"}));
  EXPECT_EQ(read("a\nb"), (Lines{"a", "b"}));
  EXPECT_EQ(read(""), Lines());
}

TEST_F(GzipLinesTest, MayBeLongerThanAnyBlockThatIsReadAtOnce)
{
  const std::string longLine(1 << 20, 'x');
  EXPECT_EQ(read("a\n" + longLine + "\nb\n"), (Lines{"a", longLine, "b"}));
}

TEST_F(GzipLinesTest, ALineWithoutEndIsNotGathered)
{
  std::ofstream(path_, std::ios::binary)
      << "a\n"
      << std::string(GzipLines::kLongest_bytes + (1 << 20), 'x') << "\nb\n";
  GzipLines lines(path_);
  std::string_view line;
  EXPECT_TRUE(lines.next(line));
  EXPECT_EQ(lines.error(), "");
  EXPECT_FALSE(lines.next(line));
  EXPECT_FALSE(lines.next(line)) << "nothing comes after it";
  EXPECT_EQ(lines.error(), "line 2 is longer than 16 MB");
}

TEST_F(GzipLinesTest, OfAFileThatIsMissingThereAreNone)
{
  GzipLines lines(folder_.path("absent"));
  std::string_view line;
  EXPECT_FALSE(lines.isOpen());
  EXPECT_FALSE(lines.next(line));
}
}  // namespace
}  // namespace psmks
