/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/gzip/GzipLines.h>
#include <psmks/logs/CarmenGeometry.h>
#include <psmks/logs/CarmenOptions.h>
#include <psmks/logs/CarmenSurvey.h>
#include <psmks/logs/LogReader.h>
#include <psmks/motion/OdometryTrack.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace psmks
{
/** Reads a log of the Carnegie Mellon Robot Navigation Toolkit (CARMEN), gzipped or not. A sensor
 * has the name of its messages: FLASER, RLASER, ROBOTLASER1, ROBOTLASER2, RAWLASER1 to RAWLASER5.
 *
 * - Odometry is the pose of the robot in the messages of the scans. If it is zero throughout, that
 * of the ODOM messages is used. If this is zero as well, there is none.
 * - RAWLASER messages are left out where the log has the same scans with the pose of the robot, see
 * CarmenSurvey::leaveOutRepetitions().
 * - Scans come in the order of the file and keep their stamps, even if these repeat or go
 * backwards.
 * - A malformed message is skipped; see remarks(). A range that is NaN, infinite or not positive is
 *   no return.
 * - For bearings, mounting and maximum range see CarmenGeometry. */
class CarmenReader : public LogReader
{
 public:
  /** Reads the whole log once to find its sensors, stamps and parameters.
   *  @param sensorLabel the sensor to read; by default that of the first scan in the log */
  explicit CarmenReader(const std::string& path,
                        std::optional<std::string> sensorLabel = std::nullopt,
                        const CarmenOptions& options = CarmenOptions());

  bool next(LaserFrame& frame) override;
  const std::string& damage() const override { return damage_; }
  std::vector<std::string> remarks() const override;
  int entriesRead() const override { return entriesRead_; }
  const std::optional<std::string>& sensorLabel() const override { return sensorLabel_; }
  const std::map<std::string, int>& scansOfSensors() const override { return scansOfSensors_; }
  int stampsMadeUp() const override { return stampsMadeUp_; }
  double shareRead() const override { return lines_.shareRead(); }

 private:
  std::string damageAtStart() const;
  bool take(LaserFrame& frame);
  void takeOdometry();
  bool takeScan(LaserFrame& frame);
  mrpt::obs::CObservation2DRangeScan::Ptr observation(double stamp_s);
  std::optional<double> statedStamp_s() const;
  std::optional<Pose2> odometryUntil(double stamp_s);
  std::optional<Pose2> odometryAt(double stamp_s) const;

  CarmenSurvey survey_;
  GzipLines lines_;
  std::optional<std::string> sensorLabel_;
  std::optional<CarmenStamp> stamp_;
  CarmenOdometry odometry_;
  std::map<std::string, CarmenGeometry> geometries_;
  std::string damage_;
  std::map<std::string, int> scansOfSensors_;
  int entriesRead_ = 0;
  int stampsMadeUp_ = 0;

  CarmenMessage message_;
  mrpt::obs::CSensoryFrame observations_;  //!< those since the last frame
  double lastStamp_s_ = 0;
  OdometryTrack track_;               //!< poses of the ODOM messages by their stamps
  std::optional<Pose2> T_odom_read_;  //!< pose of the last ODOM message
  std::optional<Pose2> T_odom_last_;  //!< pose at the last frame
};
}  // namespace psmks
