/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/support/ReplacedFile.h>
#include <gtest/gtest.h>
#include <tests/support/Program.h>
#include <tests/support/ScratchFolder.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace psmks
{
namespace
{
namespace fs = std::filesystem;

class ReplacedFileTest : public testing::Test
{
 protected:
  static bool write(const std::string& path, const std::string& text)
  {
    std::ofstream file(path);
    file << text;
    file.close();
    return !file.fail();
  }

  long files() const
  {
    return std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator());
  }

  const test::ScratchFolder folder_;
  const std::string path_ = folder_.path("map.png");
};

TEST_F(ReplacedFileTest, TakesThePlaceWhenItIsWhole)
{
  write(path_, "before");
  {
    ReplacedFile file(path_);
    EXPECT_EQ(fs::path(file.beside()).extension(), ".png");
    EXPECT_EQ(fs::path(file.beside()).parent_path(), fs::canonical(folder_.path()));
    write(file.beside(), "after");
    EXPECT_EQ(fileText(path_), "before");
    EXPECT_TRUE(file.moveIntoPlace());
  }
  EXPECT_EQ(fileText(path_), "after");
  EXPECT_EQ(files(), 1);
}

TEST_F(ReplacedFileTest, IsRemovedWhereItIsNotMoved)
{
  write(path_, "before");
  write(ReplacedFile(path_).beside(), "half");
  EXPECT_TRUE(replaceFile(path_, [](const std::string& beside) { return write(beside, "whole"); }));
  EXPECT_FALSE(replaceFile(path_,
                           [](const std::string& beside)
                           {
                             write(beside, "half");
                             return false;
                           }));
  EXPECT_FALSE(
      replaceFile(path_, [](const std::string&) -> bool { throw std::runtime_error(""); }));
  EXPECT_EQ(fileText(path_), "whole");
  std::error_code ignored;
  fs::remove(folder_.path(".psmks-" + std::to_string(getpid()) + "-map.png"), ignored);
  EXPECT_EQ(files(), 1);
}

TEST_F(ReplacedFileTest, OfALinkIsTheFileThatItNames)
{
  const std::string target = folder_.path("target.png");
  write(target, "before");
  fs::create_symlink(target, path_);
  EXPECT_TRUE(replaceFile(path_, [](const std::string& beside) { return write(beside, "after"); }));
  EXPECT_TRUE(fs::is_symlink(path_));
  EXPECT_EQ(fileText(target), "after");
}

TEST_F(ReplacedFileTest, OfADeviceIsWrittenInPlace)
{
  EXPECT_EQ(ReplacedFile("/dev/null").beside(), "/dev/null");
  EXPECT_TRUE(replaceFile("/dev/null", [](const std::string& at) { return write(at, "text"); }));
  if (fs::exists("/dev/full"))
  {
    EXPECT_FALSE(replaceFile("/dev/full", [](const std::string& at) { return write(at, "text"); }));
  }
  EXPECT_TRUE(fs::exists("/dev/null"));
}

TEST_F(ReplacedFileTest, IsCreatableWhereItsFolderIs)
{
  EXPECT_TRUE(isCreatable(path_));
  EXPECT_TRUE(isCreatable("map.png"));
  EXPECT_TRUE(isCreatable("/dev/null"));
  EXPECT_FALSE(isCreatable(folder_.path("no/map.png")));
  EXPECT_FALSE(isCreatable(folder_.path())) << "a folder";
  EXPECT_EQ(files(), 0) << "nothing was created";
}
}  // namespace
}  // namespace psmks
