/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/gzip/GzipOutput.h>
#include <psmks/logs/LogReader.h>
#include <psmks/mrpt/Convert.h>

#include <optional>
#include <string>

namespace psmks
{
/** Writes the scans of one sensor and the odometry as a CARMEN log, gzipped where its name ends in
 * ".gz".
 *
 * The messages are FLASER, which every program reads, where the scanner sits on the robot's long
 * axis, looks straight ahead and begins with the bearing that CarmenGeometry expects; else
 * ROBOTLASER1. Numbers have as many digits as it takes to read the same number back. Where the log
 * has no odometry, the robot stands still. CARMEN knows no tilt: it is lost. */
class CarmenWriter
{
 public:
  /** False where the file cannot be created. */
  bool open(const std::string& path) { return file_.open(path); }

  /** Leaves out a scan of fewer than two rays.
   *  @return false where the file cannot be written to
   *  @throws std::runtime_error where the scanner has other bearings or another place than before:
   *          a CARMEN log holds one mounting */
  bool write(const LaserFrame& frame);

  /** False where the last bytes cannot be written. */
  bool close() { return file_.close(); }

 private:
  /** What stays the same from scan to scan. Bearings are symmetric about the sensor's x axis. */
  struct Scanner
  {
    Pose2 T_robot_sensor;
    double increment_deg = 0;
    int rays = 0;

    double halfAperture_deg() const { return increment_deg * (rays - 1) / 2; }
    bool fitsFlaser() const;
    bool isNear(const Scanner& other) const;
  };
  Scanner scannerOf(const LaserFrame& frame) const;
  std::string header(const LaserFrame& frame) const;
  std::string flaser() const;
  std::string robotLaser(const LaserFrame& frame) const;
  std::string ranges() const;

  GzipOutput file_;
  ScanConverter converter_;
  Scan scan_;
  std::optional<Scanner> scanner_;  //!< none before the first scan
  Pose2 T_start_robot_;
};
}  // namespace psmks
