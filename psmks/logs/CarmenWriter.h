/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/gzip/GzipOutput.h>
#include <psmks/logs/LogReader.h>
#include <psmks/mrpt/Convert.h>

#include <optional>
#include <string>

namespace psmks
{
/** Writes the scans of one sensor and the odometry as a CARMEN log, gzipped if its name ends in
 * ".gz".
 *
 * The messages are FLASER, which every program reads, if the scanner is mounted on the x axis of
 * the robot, looks straight ahead and begins with the bearing that CarmenGeometry expects.
 * Otherwise they are ROBOTLASER1. Numbers have as many digits as are needed to read the same number
 * back. If the log has no odometry, the robot stands still in the CARMEN log. CARMEN logs have no
 * tilt, so a tilt of the scanner is lost. */
class CarmenWriter
{
 public:
  /** Creates the file.
   *  @return false if it cannot be created */
  bool open(const std::string& path) { return file_.open(path); }

  /** Appends a scan. Scans of fewer than two rays are left out.
   *  @return false if the file cannot be written
   *  @throws std::runtime_error if bearings or mounting differ from those of the first scan,
   *      for a CARMEN log has one mounting */
  bool write(const LaserFrame& frame);

  /** Closes the file.
   *  @return false if the last bytes cannot be written */
  bool close() { return file_.close(); }

 private:
  /** The geometry of the scanner, which is the same for all scans. The bearings are symmetric about
   * the x axis of the sensor. */
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
  std::optional<Scanner> scanner_;  //!< empty before the first scan
  Pose2 T_start_robot_;
};
}  // namespace psmks
