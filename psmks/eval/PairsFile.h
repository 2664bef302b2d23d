/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Pose2.h>
#include <psmks/geometry/Scan.h>
#include <psmks/gzip/GzipOutput.h>

#include <memory>
#include <stdexcept>
#include <string>

namespace psmks
{
/** A file of scan pairs that cannot be opened, read or written. The text gives file, line and
 * reason. */
class PairsFileError : public std::runtime_error
{
 public:
  using std::runtime_error::runtime_error;
};

/** Two scans, the true motion between them and that measured by odometry. */
struct ScanPair
{
  int id = 0;
  Pose2 T_ref_cur_true;
  Pose2 T_ref_cur_odometry;
  Scan reference, current;  //!< range 0 = no return
};

/** The properties that all pairs of a file share. */
struct PairsHeader
{
  BeamGrid grid;
  double maxRange_m = 0;
  int pairs = 0;
};

/** Reads a file of scan pairs, plain or gzipped, one pair at a time.
 *
 * \verbatim
 *     PSMPAIRS 1
 *     # comment
 *     laser <rays> <first bearing rad> <increment rad> <max range m>
 *     npairs <N>
 *     pair <id> <x y phi: truth> <x y phi: odometry>     m, m, rad: p_ref = R(phi) p_cur + (x, y)
 *     <ranges of the reference scan, m, 0 = no return>
 *     <ranges of the current scan>
 * \endverbatim
 *
 * Every member function throws PairsFileError if the file breaks this format. Pairs that were read
 * before the damage are valid. */
class PairsReader
{
 public:
  explicit PairsReader(const std::string& path);
  ~PairsReader();

  const PairsHeader& header() const { return header_; }

  /** Reads the next pair.
   *  @return false after the last pair that the header announces */
  bool read(ScanPair& pair);

 private:
  class Lines;
  void readHeader();
  void readRanges(Scan& scan);

  std::unique_ptr<Lines> lines_;
  PairsHeader header_;
  int pairsRead_ = 0;
};

/** Writes a file in the format of PairsReader, gzipped if its name ends in ".gz". */
class PairsWriter
{
 public:
  /** Creates the file.
   *  @throws PairsFileError if it cannot be created */
  PairsWriter(const std::string& path, const PairsHeader& header);

  /** Appends a pair.
   *  @throws PairsFileError if the file cannot be written */
  void write(const ScanPair& pair);

  /** Has to be called after the last pair: without it, errors of the last bytes stay unnoticed.
   *  @throws PairsFileError if they cannot be written */
  void close();

 private:
  void put(const std::string& text);

  std::string path_;
  GzipOutput file_;
};
}  // namespace psmks
