/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <psmks/geometry/BeamTiming.h>
#include <psmks/geometry/Pose2.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace psmks
{
/** One scan of a log, and everything that the log holds since the scan before. */
struct LaserFrame
{
  mrpt::obs::CObservation2DRangeScan::Ptr scan;

  /** Time of the scan in seconds since the epoch. If the scan has no stamp, it is that of its
   * actions or made up, see LogReader::stampsMadeUp(). */
  double stamp_s = 0;

  /** The motion of the robot since the frame before, measured by odometry; nothing if there is
   * none.
   */
  std::optional<Pose2> odometry;

  /** When the scanner casts its rays; a time of 0 if it is unknown. */
  BeamTiming beam;

  /** All observations since the frame before, including this scan and without odometry. */
  mrpt::obs::CSensoryFrame observations;
};

/** The time between two scans of a log without any stamps. */
constexpr double kAssumedPeriod_s = 0.1;

/** Reads the scans of one sensor from a log, in the order of the file.
 *
 * A damaged file causes no exception. What can be read is read; damage() and remarks() say what
 * could not be read. */
class LogReader
{
 public:
  virtual ~LogReader() = default;

  /** Reads the next scan.
   *  @return false at the end of the log, or of what can be read of it */
  virtual bool next(LaserFrame& frame) = 0;

  /** Why reading ended before the end of the log, as a part of a sentence such as "read 12 entries,
   * then: ..."; empty if all of it was read. */
  virtual const std::string& damage() const = 0;

  /** What a user should know about a log although it was read to its end, such as skipped entries
   * and stamps that repeat. Each remark is a sentence without a full stop. The list is complete
   * after the last scan. */
  virtual std::vector<std::string> remarks() const { return {}; }

  /** The number of entries of any kind that were read so far. */
  virtual int entriesRead() const = 0;

  /** The sensor whose scans are read; nothing before the first scan, unless a sensor was chosen. */
  virtual const std::optional<std::string>& sensorLabel() const = 0;

  /** The number of 2D scans of each sensor so far. */
  virtual const std::map<std::string, int>& scansOfSensors() const = 0;

  /** The number of scans whose time had to be made up because neither they nor their actions have a
   * stamp. */
  virtual int stampsMadeUp() const = 0;

  /** The share of the log that was read, 0 to 1, for progress bars. */
  virtual double shareRead() const = 0;
};
}  // namespace psmks
