/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace psmks
{
/** A file to write, gzipped where its name ends in ".gz". */
class GzipOutput
{
 public:
  /** False where the file cannot be created. */
  bool open(const std::string& path);

  /** False where the file cannot be written to. */
  bool write(std::string_view text);

  /** False where the last bytes cannot be written. */
  bool close();

 private:
  struct Close
  {
    void operator()(void* file) const;
  };
  std::unique_ptr<void, Close> file_;  //!< gzFile, which would bring zlib.h in here
};
}  // namespace psmks
