/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/gzip/GzipInput.h>
#include <psmks/gzip/GzipOutput.h>
#include <tests/support/ScratchFolder.h>

#include <filesystem>
#include <fstream>

namespace psmks
{
namespace
{
/** A text that gzip cannot shrink below a few kilobytes: the squares from 0 on. */
std::string longText()
{
  std::string text;
  for (int i = 0; i < 5000; ++i) text += std::to_string(i * i) + '\n';
  return text;
}

std::string readAll(GzipInput& input)
{
  std::string text;
  char block[1000];
  while (const std::size_t bytes = input.Read(block, sizeof block)) text.append(block, bytes);
  return text;
}

class GzipInputTest : public testing::Test
{
 protected:
  /** Writes a text, gzipped if the name ends in ".gz". */
  std::string write(const std::string& name, const std::string& text) const
  {
    GzipOutput output;
    EXPECT_TRUE(output.open(folder_.path(name)));
    EXPECT_TRUE(output.write(text));
    EXPECT_TRUE(output.close());
    return folder_.path(name);
  }

  const test::ScratchFolder folder_;
};

TEST_F(GzipInputTest, ReadsPlainAndGzippedFilesAlike)
{
  for (const char* name : {"text", "text.gz"})
  {
    GzipInput input(write(name, longText()));
    ASSERT_TRUE(input.isOpen()) << name;
    EXPECT_FALSE(input.isAtEnd()) << name;
    EXPECT_EQ(readAll(input), longText()) << name;
    EXPECT_TRUE(input.isAtEnd()) << name;
    EXPECT_EQ(input.error(), "") << name;
  }
}

TEST_F(GzipInputTest, IsNotOpenWithoutARegularFile)
{
  EXPECT_FALSE(GzipInput(folder_.path("absent")).isOpen());
  EXPECT_FALSE(GzipInput(folder_.path("")).isOpen());
}

TEST_F(GzipInputTest, LookingForTheEndLosesNoByte)
{
  GzipInput input(write("text.gz", "ab"));
  EXPECT_FALSE(input.isAtEnd());
  EXPECT_FALSE(input.isAtEnd());
  EXPECT_EQ(readAll(input), "ab");
}

TEST_F(GzipInputTest, TheShareReadRisesFromNoneToAll)
{
  GzipInput input(write("text", longText()));
  double last = 0;
  char block[20000];
  while (input.Read(block, sizeof block) > 0)
  {
    EXPECT_GE(input.shareRead(), last);
    last = input.shareRead();
  }
  EXPECT_EQ(last, 1);
}

TEST_F(GzipInputTest, SaysThatCompressedDataIsCutOff)
{
  const std::string path = write("text.gz", longText());
  std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
  GzipInput input(path);
  const std::string text = readAll(input);
  EXPECT_EQ(input.error(), "the compressed data is cut off");
  EXPECT_GT(text.size(), 0u);
  EXPECT_EQ(text, longText().substr(0, text.size()));
}

TEST_F(GzipInputTest, SaysThatCompressedDataIsDamaged)
{
  const std::string path = write("text.gz", longText());
  const auto middle = static_cast<std::streamoff>(std::filesystem::file_size(path) / 2);
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(middle).write("\xff\xff\xff\xff\xff\xff\xff\xff", 8);
  file.close();
  GzipInput input(path);
  readAll(input);
  EXPECT_EQ(input.error(), "the compressed data is damaged");
}
}  // namespace
}  // namespace psmks
