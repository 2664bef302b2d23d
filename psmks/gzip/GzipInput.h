/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <cstddef>
#include <string>

namespace psmks
{
/** A file to read, gzipped or plain, that knows how it ended: MRPT's streams end a cut-off file as
 * they end a whole one. Has the functions that mrpt::serialization::archiveFrom() asks for. */
class GzipInput
{
 public:
  explicit GzipInput(const std::string& path);
  ~GzipInput();
  GzipInput(const GzipInput&) = delete;
  GzipInput& operator=(const GzipInput&) = delete;

  bool isOpen() const { return file_ != nullptr; }

  /** True where there is no further byte to read, for whatever reason. */
  bool isAtEnd();

  /** Why reading ended too early, e.g. "the compressed data is cut off"; empty where it did not. */
  std::string error() const;

  /** Share of the file's bytes that were read, 0 to 1. */
  double shareRead() const;

  std::size_t Read(void* buffer, std::size_t bytes);
  std::size_t Write(const void* buffer, std::size_t bytes);
  std::string getStreamDescription() const { return path_; }

 private:
  std::string path_;
  void* file_ = nullptr;  //!< gzFile, which would bring zlib.h in here
  double size_bytes_ = 0;
};
}  // namespace psmks
