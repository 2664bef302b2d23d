/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <mrpt/core/Clock.h>
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <psmks/geometry/Scan.h>
#include <psmks/logs/LogReader.h>
#include <psmks/motion/OdometryNoise.h>

#include <optional>
#include <string>

namespace psmks
{
/** The two kinds of MRPT's rawlogs. */
enum class RawlogFormat
{
  Actions,      //!< a motion and a sensory frame in turn
  Observations  //!< the pose by odometry and a scan in turn
};

/** The scan as MRPT's observation: rays from right to left; one without return is flagged invalid
 * and reads the maximum range. An unknown range sigma leaves MRPT's default.
 *
 * MRPT lays the rays of a scan symmetrically about the x axis of its sensor: where the grid is not,
 * as on a full circle, the sensor is turned instead. */
mrpt::obs::CObservation2DRangeScan::Ptr toMrpt(const Scan& scan, const Pose2& T_robot_sensor);

/** Writes the scans and the odometry of a drive as a gzipped rawlog. The same input gives the same
 * bytes. Sensors that have no name of their own are called LASER1 and, in a log of observations,
 * ODOMETRY. */
class RawlogWriter
{
 public:
  struct Options
  {
    RawlogFormat format = RawlogFormat::Actions;
    Pose2 T_robot_sensor;
    OdometryOptions odometry;  //!< how far a log of actions says that its motions can be trusted
  };

  explicit RawlogWriter(const Options& options) : options_(options) {}

  /** False where the file cannot be created. */
  bool open(const std::string& path) { return file_.open(path); }

  /** One scan and where the wheels say that the robot was then; in the order of the stamps.
   *  @throws std::exception where the file cannot be written */
  void write(const Scan& scan, const Pose2& T_start_odometry);

  /** The next frame of another log, all its observations included. A scan without a stamp gets that
   *  of the frame. Where the frame has no odometry, the log has none there, but for the first
   *  frame, which stands at the start.
   *  @throws std::exception where the file cannot be written */
  void write(const LaserFrame& frame);

  /** The time that a stamp has in the log: MRPT counts in 100 ns. */
  static double loggedStamp_s(double stamp_s)
  {
    return mrpt::Clock::toDouble(mrpt::Clock::fromDouble(stamp_s));
  }

 private:
  void writeActions(const LaserFrame& frame);
  void writeObservations(const LaserFrame& frame);

  Options options_;
  mrpt::io::CFileGZOutputStream file_;
  std::optional<Pose2> T_start_odometry_;  //!< at the last frame; none before the first
};
}  // namespace psmks
