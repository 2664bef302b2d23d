/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace psmks
{
/** A file to write, gzipped if its name ends in ".gz", plain otherwise. The destructor closes it
 * without reporting errors. */
class GzipOutput
{
 public:
  /** Creates the file.
   *  @return false if it cannot be created */
  bool open(const std::string& path);

  /** Appends a text. The file must be open.
   *  @return false if it cannot be written */
  bool write(std::string_view text);

  /** Writes what is buffered and closes the file. The file must be open.
   *  @return false if the last bytes cannot be written */
  bool close();

 private:
  struct Close
  {
    void operator()(void* file) const;
  };
  std::unique_ptr<void, Close> file_;  //!< a gzFile; naming that type here would need zlib.h
};
}  // namespace psmks
