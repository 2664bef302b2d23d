/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/support/LogFlags.h>
#include <apps/support/LogScan.h>
#include <psmks/eval/Relations.h>

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

namespace psmks
{
/** A log with what is known of its truth. */
struct Log
{
  std::string title;
  std::vector<LogScan> scans;
  std::optional<Trajectory> groundTruth;
  std::vector<Relation> relations;  //!< empty if there are none
};

/** The logs of a command line. */
class LogInput
{
 public:
  /** Adds the argument LOG and the flags that choose its scans and say how it is read. */
  void addLogFlags(CLI::App& app);

  void addGroundTruthFlag(CLI::App& app);
  void addRelationsFlag(CLI::App& app);

  /** @throws CLI::ValidationError if a truth is given together with several logs */
  void check() const;

  /** Reads the logs and returns those with a usable scan. What is wrong with the other ones is
   * reported on stderr.
   *  @param options of the mounting, see toLogScan()
   *  @throws ProgramError if a truth cannot be read */
  std::vector<Log> read(const ScanMatcherOptions& options);

  /** Whether a log was missing or damaged. */
  bool isDamaged() const { return damaged_; }

 private:
  Log readLog(const std::string& path, const ScanMatcherOptions& options);
  void readScans(const std::string& path, const ScanMatcherOptions& options,
                 std::vector<LogScan>& scans);

  std::vector<std::string> paths_;
  LogFlags flags_;
  std::string groundTruth_, relations_;
  int skipScans_ = 0;
  int maxScans_ = 0;
  bool damaged_ = false;
};
}  // namespace psmks
