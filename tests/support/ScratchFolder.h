/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <string>

namespace psmks::test
{
/**
 * A folder of its own for what a test writes, below testing::TempDir(); at its end it is removed
 * with all that is in it. No two share a path, whatever tests run at once, in this process and in
 * others. Throws std::system_error where no folder can be made.
 */
class ScratchFolder
{
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  /** Absolute, without a slash at the end. */
  const std::string& path() const { return path_; }
  /** Of a file in it, which need not exist. */
  std::string path(const std::string& name) const { return path_ + '/' + name; }

 private:
  std::string path_;
};
}  // namespace psmks::test
