/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <psmks/geometry/Pose2.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace psmks
{
/** One scan of a log, with what led to it. */
struct LaserFrame
{
  mrpt::obs::CObservation2DRangeScan::Ptr scan;

  /** Time of the scan, seconds since the epoch; of its actions, or made up, where it has none. */
  double stamp_s = 0;

  /** Motion of the robot since the frame before, as its wheels measured it; none where they did
   * not. */
  std::optional<Pose2> odometry;

  /** Time in which the scanner's beam goes once round; 0 where the log does not tell. */
  double beamTurn_s = 0;

  /** Everything observed since the frame before, this scan included, odometry left out. */
  mrpt::obs::CSensoryFrame observations;
};

/** Between scans of a log without any stamps. */
constexpr double kAssumedPeriod_s = 0.1;

/** Reads the scans of one sensor from a log, in the order of the file.
 *
 * Nothing here throws for a damaged file: what can be read is read, damage() and remarks() say what
 * could not. */
class LogReader
{
 public:
  virtual ~LogReader() = default;

  /** The next scan; false at the end of the log or of what can be read of it. */
  virtual bool next(LaserFrame& frame) = 0;

  /** Why the log ended before its end, as half a sentence: "read 12 entries, then: ..."; empty for
   * a whole log. */
  virtual const std::string& damage() const = 0;

  /** What a user should know of a log that was read to its end, a sentence each, without a full
   * stop: entries that were skipped, stamps that repeat. Complete after the last scan. */
  virtual std::vector<std::string> remarks() const { return {}; }

  /** Entries of the log read so far, of whatever class. */
  virtual int entriesRead() const = 0;

  /** The sensor that is read; none before the first scan unless one was asked for. */
  virtual const std::optional<std::string>& sensorLabel() const = 0;

  /** How many 2D scans of which sensor were met so far. */
  virtual const std::map<std::string, int>& scansOfSensors() const = 0;

  /** Scans whose time had to be made up: neither they nor their actions have a stamp. */
  virtual int stampsMadeUp() const = 0;

  /** For progress bars, 0 to 1. */
  virtual double shareRead() const = 0;
};
}  // namespace psmks
