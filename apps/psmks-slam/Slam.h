/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-slam/CommandLine.h>
#include <apps/psmks-slam/OutputFolder.h>
#include <apps/support/ExitCode.h>
#include <apps/support/LogScan.h>
#include <apps/support/ReplacedFile.h>
#include <mrpt/maps/CSimpleMap.h>
#include <psmks/base/Stopwatch.h>
#include <psmks/draw/MapFiles.h>
#include <psmks/eval/Relations.h>
#include <psmks/logs/OpenLog.h>
#include <psmks/slam/TrajectoryBuilder.h>

#include <memory>
#include <optional>

namespace psmks
{
/** Runs psmks-slam, from a log to the files of its output folder. */
class Slam
{
 public:
  /** Checks everything that can be checked before the work begins.
   *  @throws ProgramError, OptionError, TrajectoryFileError if a file, an option or a ground
   *      truth cannot be accepted */
  Slam(const CommandLine& commandLine, const SlamOptions& options);

  /** Does the work, to its end or until a signal asks to stop, and writes what was done. If
   * something was wrong, one sentence on stderr says so.
   *  @throws ProgramError if nothing could be done */
  ExitCode run();

 private:
  void buildTrajectory();
  void add(const LaserFrame& frame);
  void keepKeyframes(const LaserFrame& frame);
  mrpt::maps::CSimpleMap simpleMap() const;
  std::vector<std::string> remarks() const;
  void reportLog() const;
  LogSummary logSummary() const;
  Summary trajectorySummary() const;
  RunSummary writeResults();
  RunResults runResults() const;
  void writeFiles(RunResults& results);
  void divideBuildingTime();
  void requireScans() const;
  ExitCode exitCodeOfRun(const RunSummary& summary);

  CommandLine commandLine_;
  SlamOptions options_;
  std::optional<Trajectory> groundTruth_;
  std::vector<Relation> relations_;  //!< empty if there are none
  OutputFolder output_;
  Stopwatch watch_;
  std::unique_ptr<LogReader> reader_;
  TrajectoryBuilder builder_;
  ScanConverter converter_;
  std::vector<std::pair<std::size_t, LaserFrame>> keyframes_;  //!< with the index of their scans
  std::optional<LaserFrame> lastFrame_;  //!< the last frame, if it is not a key frame yet
  std::optional<ReplacedFile> rawlogFile_;
  std::optional<MatchedRawlog> rawlog_;
  int scansWithoutOdometry_ = 0;
  RunTimes times_;
};
}  // namespace psmks
