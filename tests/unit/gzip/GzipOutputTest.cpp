/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/gzip/GzipInput.h>
#include <psmks/gzip/GzipOutput.h>
#include <tests/support/Program.h>
#include <tests/support/ScratchFolder.h>

#include <filesystem>
#include <stdexcept>

namespace psmks
{
namespace
{
const test::ScratchFolder kFolder;

std::string inflated(const std::string& path)
{
  GzipInput file(path);
  std::string text(100, ' ');
  text.resize(file.Read(text.data(), text.size()));
  return text;
}

TEST(GzipOutput, IsGzippedByItsNameOrAlways)
{
  for (const auto& [name, use, isGzipped] : {std::tuple{"a.log", GzipUse::ByName, false},
                                             {"a.log.gz", GzipUse::ByName, true},
                                             {"a.rawlog", GzipUse::Always, true}})
  {
    GzipOutput file;
    const std::string path = kFolder.path(name);
    ASSERT_TRUE(file.open(path, use));
    EXPECT_TRUE(file.write("hello "));
    EXPECT_EQ(file.Write("world", 5), 5u);
    EXPECT_TRUE(file.close());
    EXPECT_EQ(inflated(path), "hello world");
    EXPECT_EQ(fileText(path) != "hello world", isGzipped) << name;
  }
}

TEST(GzipOutput, TellsThatADiskIsFull)
{
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  for (const GzipUse use : {GzipUse::ByName, GzipUse::Always})
  {
    GzipOutput few, many;
    ASSERT_TRUE(few.open("/dev/full", use));
    few.write("few bytes, which are buffered");
    EXPECT_FALSE(few.close());
    ASSERT_TRUE(many.open("/dev/full", use));
    std::string noise(1 << 20, 'x');
    for (std::size_t i = 0; i < noise.size(); ++i)
      noise[i] = static_cast<char>(i * i * 2654435761u >> 13);
    EXPECT_EQ(many.Write(noise.data(), noise.size()), noise.size()) << "archives are not told";
    EXPECT_FALSE(many.isGood());
    EXPECT_FALSE(many.write("more"));
    EXPECT_FALSE(many.close());
  }
}

TEST(GzipOutput, CannotBeRead)
{
  GzipOutput file;
  char byte = 0;
  EXPECT_THROW(file.Read(&byte, 1), std::logic_error);
  EXPECT_FALSE(file.open(kFolder.path("no/folder")));
}
}  // namespace
}  // namespace psmks
