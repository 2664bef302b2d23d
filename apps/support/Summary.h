/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/support/OdometryJumps.h>
#include <psmks/eval/TrajectoryError.h>
#include <psmks/slam/TrajectoryBuilder.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace psmks
{
/** What is known about the log that the scans came from. */
struct LogSummary
{
  std::string path;
  std::string sensor;
  int entriesRead = 0;
  std::string damage;            //!< see LogReader::damage()
  int scansWithoutOdometry = 0;  //!< not counting the first scan
  int stampsMadeUp = 0;
};

/** Statistics of a built trajectory. Values that do not exist, as times without a match, are NaN.
 */
struct Summary
{
  LogSummary log;
  std::string matcher;
  std::size_t scans = 0;
  std::size_t references = 0;
  std::size_t matches = 0;    //!< number of matches tried
  std::size_t unmatched = 0;  //!< scans after the first without a usable match
  std::map<std::string, std::size_t> usable, failed;  //!< number of matches by status
  double pathLength_m = 0;  //!< of the way driven; steps below 0.1 m count together
  double matchMedian_s, matchP95_s;
  double segmentationMedian_s;
  std::size_t occupiedCells = 0;
  std::vector<OdometryJump> odometryJumps;
  std::optional<TrajectoryError> error;  //!< errors if there is a ground truth

  std::size_t failures() const;
};

/** Computes all statistics except those of the log and the name of the matcher.
 *  @param groundTruth of the robot; if it is missing or has no pose at the time of a scan,
 *      there is no error */
Summary summarise(const std::vector<PosedScan>& scans,
                  const std::optional<Trajectory>& groundTruth = std::nullopt);

/** The poses of the robot at its scans. */
Trajectory trajectoryOf(const std::vector<PosedScan>& scans);
Trajectory odometryOf(const std::vector<PosedScan>& scans);
}  // namespace psmks
