/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <psmks/geometry/Scan.h>
#include <psmks/gzip/GzipOutput.h>
#include <psmks/logs/LogReader.h>
#include <psmks/motion/OdometryNoise.h>

#include <optional>
#include <string>

namespace psmks
{
/** The two kinds of MRPT's rawlogs. */
enum class RawlogFormat
{
  Actions,      //!< motions and sensory frames alternate
  Observations  //!< poses by odometry and scans alternate
};

/** Converts a scan to an observation of MRPT with rays from right to left. A ray without return is
 * flagged invalid and has the maximum range. If the standard deviation of ranges is unknown, MRPT's
 * default stays.
 *
 * MRPT assumes that the rays are symmetric about the x axis of the sensor. If those of the grid are
 * not, as on a full circle, the sensor is turned accordingly. */
mrpt::obs::CObservation2DRangeScan::Ptr toMrpt(const Scan& scan, const Pose2& T_robot_sensor);

/** Writes the scans and the odometry of a drive as a gzipped rawlog. The same input gives the same
 * bytes. The label of a scanner without a name is LASER1, that of the odometry in a log of
 * observations is ODOMETRY. */
class RawlogWriter
{
 public:
  struct Options
  {
    RawlogFormat format = RawlogFormat::Actions;
    Pose2 T_robot_sensor;
    OdometryOptions odometry;  //!< noise that a log of actions states for its motions
  };

  explicit RawlogWriter(const Options& options) : options_(options) {}

  /** Creates the file.
   *  @return false if it cannot be created */
  bool open(const std::string& path) { return file_.open(path, GzipUse::Always); }

  /** Closes the file.
   *  @return false if any byte could not be written */
  bool close() { return file_.close(); }

  /** Appends a scan and the pose of the robot by odometry at its time. Scans have to come in the
   * order of their stamps.
   *  @return false if the file cannot be written */
  bool write(const Scan& scan, const Pose2& T_start_odometry);

  /** Appends a frame of another log with all its observations. A scan without a stamp gets that of
   * the frame. If the frame has no odometry, none is written for it, except that the first frame is
   * at the start.
   *  @return false if the file cannot be written */
  bool write(const LaserFrame& frame);

  /** The stamp as it is read back from the log: MRPT counts time in units of 100 ns. */
  static double loggedStamp_s(double stamp_s)
  {
    return mrpt::Clock::toDouble(mrpt::Clock::fromDouble(stamp_s));
  }

 private:
  void writeActions(const LaserFrame& frame);
  void writeObservations(const LaserFrame& frame);

  Options options_;
  GzipOutput file_;
  std::optional<Pose2> T_start_odometry_;  //!< odometry at the last frame; empty before the first
};
}  // namespace psmks
