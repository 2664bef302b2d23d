/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/gzip/GzipInput.h>

#include <string>
#include <string_view>
#include <vector>

namespace psmks
{
/** The lines of a text file, gzipped or plain. */
class CarmenLines
{
 public:
  explicit CarmenLines(const std::string& path);

  bool isOpen() const { return file_.isOpen(); }

  /** The next line, without its end; good until the next call. A line that damaged data cut off is
   *  left out: see error().
   *  @return false after the last one */
  bool next(std::string_view& line);

  /** Of the line read last, from 1. */
  int number() const { return number_; }

  /** Why reading ended too early, see GzipInput; empty where it did not. */
  std::string error() const { return file_.error(); }

  /** Share of the file's bytes that were read, 0 to 1. */
  double shareRead() const { return file_.shareRead(); }

 private:
  bool refill();

  GzipInput file_;
  std::vector<char> block_;
  std::string_view unread_;  //!< part of the block
  std::string line_;         //!< a line that began in a block before
  int number_ = 0;
};
}  // namespace psmks
