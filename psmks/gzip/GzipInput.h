/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <cstddef>
#include <string>

namespace psmks
{
/** A file to read, gzipped or plain.
 *
 * Unlike the streams of MRPT it distinguishes a file that was cut off or damaged from one that was
 * read to its end. It has the member functions that mrpt::serialization::archiveFrom() needs. */
class GzipInput
{
 public:
  /** Opens a file; see isOpen(). Only regular files are opened. */
  explicit GzipInput(const std::string& path);
  ~GzipInput();
  GzipInput(const GzipInput&) = delete;
  GzipInput& operator=(const GzipInput&) = delete;

  bool isOpen() const { return file_ != nullptr; }

  /** Whether there is no further byte to read, because of the end of the file or because of damage.
   * The file must be open. */
  bool isAtEnd();

  /** Why reading ended before the end of the file, for example "the compressed data is cut off";
   * empty if it did not. */
  std::string error() const;

  /** The share of the bytes of the file that has been read, 0 to 1. */
  double shareRead() const;

  /** Reads up to so many bytes.
   *  @return the number of bytes read; 0 at the end of the file or at damage */
  std::size_t Read(void* buffer, std::size_t bytes);
  /** Only there because MRPT's archives ask for it.
   *  @throws std::logic_error always */
  std::size_t Write(const void* buffer, std::size_t bytes);
  std::string getStreamDescription() const { return path_; }

 private:
  std::string path_;
  void* file_ = nullptr;  //!< a gzFile; naming that type here would need zlib.h
  double size_bytes_ = 0;
};
}  // namespace psmks
