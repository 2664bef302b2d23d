/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace psmks
{
/** Which files are gzipped. */
enum class GzipUse
{
  ByName,  //!< those of which the name ends in ".gz"
  Always
};

/** A file to write, gzipped or plain. The destructor closes it without reporting errors. It has the
 * member functions that mrpt::serialization::archiveFrom() needs. */
class GzipOutput
{
 public:
  /** Creates the file.
   *  @return false if it cannot be created */
  bool open(const std::string& path, GzipUse use = GzipUse::ByName);

  /** Appends bytes. The file must be open.
   *  @return false if they cannot be written */
  bool write(std::string_view text);

  /** Writes what is buffered and closes the file. The file must be open.
   *  @return false if any bytes since open() could not be written */
  bool close();

  /** Whether all bytes since open() could be written, as far as is known before close(). */
  bool isGood() const { return !failed_; }

  /** Appends bytes, as MRPT's archives ask for it. An error is told by isGood() and close() alone,
   * for an archive would throw a text of many lines.
   *  @return the number of bytes */
  std::size_t Write(const void* buffer, std::size_t bytes);

  /** Only there because MRPT's archives ask for it.
   *  @throws std::logic_error always */
  std::size_t Read(void* buffer, std::size_t bytes);
  std::string getStreamDescription() const { return path_; }

 private:
  struct Close
  {
    void operator()(void* file) const;
  };
  std::string path_;
  bool failed_ = false;
  std::unique_ptr<void, Close> file_;  //!< a gzFile; naming that type here would need zlib.h
};
}  // namespace psmks
