/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/TrajectoryError.h>
#include <psmks/slam/TrajectoryBuilder.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace psmks
{
/** Where the scans came from. */
struct LogSummary
{
  std::string path;
  std::string sensor;
  int entriesRead = 0;
  std::string damage;            //!< empty for a whole log
  int scansWithoutOdometry = 0;  //!< but for the first
  int stampsMadeUp = 0;
};

/** What building a trajectory came to. Values that do not exist (times without a match) are NaN. */
struct Summary
{
  LogSummary log;
  std::string matcher;
  std::size_t scans = 0;
  std::size_t references = 0;
  std::size_t matches = 0;                            //!< tried
  std::size_t unmatched = 0;                          //!< scans but the first that none placed
  std::map<std::string, std::size_t> usable, failed;  //!< matches by status
  double pathLength_m = 0;
  double matchMedian_s, matchP95_s;
  double segmentationMedian_s;
  std::size_t occupiedCells = 0;
  std::optional<TrajectoryError> error;  //!< against a ground truth

  std::size_t failures() const;
};

/** All but the log and the matcher's name.
 *  @param groundTruth of the same robot; without it, or where it has no pose at the time of a scan,
 *         there is no error */
Summary summarise(const std::vector<PosedScan>& scans,
                  const std::optional<Trajectory>& groundTruth = std::nullopt);

/** The robot's poses at its scans. */
Trajectory trajectoryOf(const std::vector<PosedScan>& scans);
Trajectory odometryOf(const std::vector<PosedScan>& scans);
}  // namespace psmks
