/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <mrpt/serialization/CSerializable.h>
#include <sys/types.h>

#include <cstddef>
#include <string>
#include <vector>

namespace psmks
{
/** The entries of an MRPT rawlog, gzipped or not, in the order of the file.
 *
 * MRPT believes the lengths and the names of classes that a file states, so a damaged file can
 * crash its decoder or make it ask for gigabytes. The file is therefore decoded in a process of its
 * own, which may crash, may take no more memory than the file can ask for, and no more than some
 * seconds for an entry. It hands over whole entries, encoded anew, which this process decodes
 * again:
 *
 *     file --> decoding process --(pipe: entries, at last a report)--> next()
 *
 * What was handed over is never lost. */
class RawlogEntries
{
 public:
  /** Starts the process; see damage(). */
  explicit RawlogEntries(const std::string& path);

  /** Ends the process. */
  ~RawlogEntries();
  RawlogEntries(const RawlogEntries&) = delete;
  RawlogEntries& operator=(const RawlogEntries&) = delete;

  /** Reads the next entry.
   *  @return null at the end of the log, or of what can be read of it */
  mrpt::serialization::CSerializable::Ptr next();

  /** The number of entries that next() has returned. */
  int read() const { return read_; }

  /** Why reading ended before the end of the log, see LogReader::damage(); empty if it did not. */
  const std::string& damage() const { return damage_; }

  /** The share of the bytes of the file that has been read, 0 to 1. */
  double shareRead() const { return share_; }

 private:
  void start(const std::string& path);
  bool receive(void* buffer, std::size_t bytes);
  void reportDamage(const std::string& reason);
  void reportEndOfProcess();

  int pipe_ = -1;  //!< end of the pipe to read from; -1 where there is none
  pid_t process_ = -1;
  std::vector<char> payload_;
  std::string damage_;
  int read_ = 0;
  double share_ = 0;
};
}  // namespace psmks
