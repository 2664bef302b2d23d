/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Pose2.h>
#include <psmks/geometry/Scan.h>

#include <memory>
#include <stdexcept>
#include <string>

namespace psmks
{
/** A pairs file that cannot be opened, read on or written; the text names file, line and reason. */
class PairsFileError : public std::runtime_error
{
 public:
  using std::runtime_error::runtime_error;
};

/** Two scans and the true motion between them. */
struct ScanPair
{
  int id = 0;
  Pose2 T_ref_cur_true;
  Pose2 T_ref_cur_odometry;
  Scan reference, current;  //!< range 0 = no return
};

/** What all pairs of a file share. */
struct PairsHeader
{
  BeamGrid grid;
  double maxRange_m = 0;
  int pairs = 0;
};

/** Reads a file of scan pairs, plain or gzipped, one pair at a time.
 *
 *     PSMPAIRS 1
 *     # comment
 *     laser <rays> <first bearing rad> <increment rad> <max range m>
 *     npairs <N>
 *     pair <id> <x y phi: truth> <x y phi: odometry>     m, m, rad: p_ref = R(phi) p_cur + (x, y)
 *     <ranges of the reference scan, m, 0 = no return>
 *     <ranges of the current scan>
 *
 * Every member function throws PairsFileError where the file breaks this format. Pairs read before
 * the damage stay good. */
class PairsReader
{
 public:
  explicit PairsReader(const std::string& path);
  ~PairsReader();

  const PairsHeader& header() const { return header_; }

  /** The next pair, or false after the last one that the header promises. */
  bool read(ScanPair& pair);

 private:
  class Lines;
  void readHeader();
  void readRanges(Scan& scan);

  std::unique_ptr<Lines> lines_;
  PairsHeader header_;
  int pairsRead_ = 0;
};

/** Writes such a file: gzipped where the name ends in ".gz". */
class PairsWriter
{
 public:
  /** @throws PairsFileError where the file cannot be created */
  PairsWriter(const std::string& path, const PairsHeader& header);

  /** Closes the file if close() was not called, without a word about errors. */
  ~PairsWriter();

  /** @throws PairsFileError where the file cannot be written to */
  void write(const ScanPair& pair);

  /** @throws PairsFileError where the last bytes cannot be written */
  void close();

 private:
  void put(const std::string& text);

  std::string path_;
  struct GzipClose
  {
    void operator()(void* file) const;
  };
  std::unique_ptr<void, GzipClose> file_;
};
}  // namespace psmks
