/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/logs/CarmenGeometry.h>
#include <psmks/logs/CarmenLines.h>
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
/** Reads a log of the Carnegie Mellon Robot Navigation Toolkit, gzipped or not. Its sensors are
 * called like their messages: FLASER, RLASER, ROBOTLASER1, ROBOTLASER2.
 *
 * - Odometry is that of the robot in the scans' messages; that of the ODOM messages where the
 *   scans' is zero throughout; none where both are.
 * - Scans stand in the order of the file and keep their stamps, even such as repeat or go back.
 * - A message whose numbers are not what they should be is skipped; see remarks(). A range that is
 *   NaN, infinite or not above 0 is no return.
 * - For bearings, mounting and range limit see CarmenGeometry. */
class CarmenReader : public LogReader
{
 public:
  /** Goes through the log once, to its end.
   *  @param sensorLabel the sensor to read; none: that of the first scan in the log */
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
  CarmenLines lines_;
  std::optional<std::string> sensorLabel_;
  std::optional<CarmenStamp> stamp_;
  CarmenOdometry odometry_;
  std::map<std::string, CarmenGeometry> geometries_;
  std::string damage_;
  std::map<std::string, int> scansOfSensors_;
  int entriesRead_ = 0;
  int stampsMadeUp_ = 0;

  CarmenMessage message_;
  mrpt::obs::CSensoryFrame observations_;  //!< since the last frame
  double lastStamp_s_ = 0;
  OdometryTrack track_;               //!< of the ODOM messages, by their stamps
  std::optional<Pose2> T_odom_read_;  //!< by the last ODOM message
  std::optional<Pose2> T_odom_last_;  //!< at the last frame
};
}  // namespace psmks
