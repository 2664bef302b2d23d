/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <tests/support/ScratchFolder.h>

#include <filesystem>
#include <fstream>

namespace psmks::test
{
TEST(ScratchFolder, IsRemovedWithWhatIsInIt)
{
  std::string path;
  {
    const ScratchFolder folder;
    path = folder.path();
    std::filesystem::create_directories(folder.path("a/b"));
    std::ofstream(folder.path("a/b/file")) << "text";
    EXPECT_TRUE(std::filesystem::exists(path + "/a/b/file"));
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(ScratchFolder, IsNobodyElses)
{
  const ScratchFolder one, other;
  EXPECT_NE(one.path(), other.path());
  std::ofstream(one.path("file")) << "text";
  EXPECT_FALSE(std::filesystem::exists(other.path("file")));
}
}  // namespace psmks::test
