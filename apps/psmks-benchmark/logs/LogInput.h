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
/** A log that every matcher is run on. */
struct Log
{
  std::string title;
  std::vector<LogScan> scans;
  std::optional<Trajectory> groundTruth;
  std::vector<Relation> relations;  //!< empty where there are none
};

/** The logs of a command line, with what is known of the truth. */
class LogInput
{
 public:
  /** LOG, which scans of it, and how to read them. */
  void addLogFlags(CLI::App& app);

  void addGroundTruthFlag(CLI::App& app);
  void addRelationsFlag(CLI::App& app);

  /** @throws CLI::ValidationError for a truth of several logs */
  void check() const;

  /** Those of the logs that hold a usable scan; what is wrong with the others is said on stderr.
   *  @param options of the mounting, see toLogScan()
   *  @throws ProgramError for a truth that cannot be read */
  std::vector<Log> read(const ScanMatcherOptions& options);

  /** Whether a log was missing or broken. */
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
