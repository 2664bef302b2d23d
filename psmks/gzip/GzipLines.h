/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/gzip/GzipInput.h>

#include <string>
#include <string_view>
#include <vector>

namespace psmks
{
/** Reads a text file, gzipped or plain, line by line. */
class GzipLines
{
 public:
  explicit GzipLines(const std::string& path);

  bool isOpen() const { return file_.isOpen(); }

  /** Longest line. Definition: the longest message of the largest scanner has a tenth of it. */
  static constexpr std::size_t kLongest_bytes = 1 << 24;

  /** Reads the next line, without its end. A line that damage of the file cut off is not delivered,
   * nor is one that is longer than kLongest_bytes, nor any after it; error() then says so.
   *  @param[out] line valid until the next call
   *  @return false after the last line, and if the file could not be opened */
  bool next(std::string_view& line);

  /** The number of the line that was read last, counted from 1. */
  int number() const { return number_; }

  /** Why reading ended before the end of the file, see GzipInput::error(); empty if it did not. */
  std::string error() const;

  /** The share of the bytes of the file that has been read, 0 to 1. */
  double shareRead() const { return file_.shareRead(); }

 private:
  bool refill();

  GzipInput file_;
  std::vector<char> block_;
  std::string_view unread_;  //!< the part of the block that was not delivered yet
  std::string line_;         //!< a line that began in an earlier block
  int number_ = 0;
  bool isTooLong_ = false;  //!< whether the next line is
};
}  // namespace psmks
