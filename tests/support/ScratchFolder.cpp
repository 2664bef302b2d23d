/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <stdlib.h>
#include <tests/support/ScratchFolder.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

namespace psmks::test
{
ScratchFolder::ScratchFolder()
    : path_(std::filesystem::absolute(testing::TempDir() + "psmks-XXXXXX").string())
{
  if (!mkdtemp(path_.data())) throw std::system_error(errno, std::generic_category(), path_);
}

ScratchFolder::~ScratchFolder()
{
  std::error_code ignored;  // a folder that cannot be removed must not fail a test
  std::filesystem::remove_all(path_, ignored);
}
}  // namespace psmks::test
