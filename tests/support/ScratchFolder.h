/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <string>

namespace psmks::test
{
/** A folder below testing::TempDir() for the files of one test. The destructor removes it with all
 * its content. All scratch folders have different paths, also those of tests that run at the same
 * time in other processes.
 *  @throws std::system_error if the folder cannot be created */
class ScratchFolder
{
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  /** The absolute path without a slash at its end. */
  const std::string& path() const { return path_; }
  /** The path of a file in the folder, which need not exist. */
  std::string path(const std::string& name) const { return path_ + '/' + name; }

 private:
  std::string path_;
};
}  // namespace psmks::test
