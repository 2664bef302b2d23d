/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <mrpt/obs/CActionCollection.h>
#include <psmks/gzip/GzipInput.h>
#include <psmks/logs/LogReader.h>
#include <psmks/motion/MotionBetweenScans.h>

#include <deque>
#include <map>
#include <optional>
#include <string>

namespace psmks
{
/** Reads an MRPT rawlog, gzipped or not, of both kinds: actions and sensory frames, or single
 * observations. */
class RawlogReader : public LogReader
{
 public:
  /** @param sensorLabel the sensor to read; by default that of the first scan in the log */
  explicit RawlogReader(const std::string& path,
                        std::optional<std::string> sensorLabel = std::nullopt);

  bool next(LaserFrame& frame) override;
  const std::string& damage() const override { return damage_; }
  int entriesRead() const override { return entriesRead_; }
  const std::optional<std::string>& sensorLabel() const override { return sensorLabel_; }
  const std::map<std::string, int>& scansOfSensors() const override { return scansOfSensors_; }
  int stampsMadeUp() const override { return stampsMadeUp_; }
  double shareRead() const override { return file_.shareRead(); }

 private:
  bool readEntry();
  void reportDamage(const std::string& error);
  void take(const mrpt::serialization::CSerializable::Ptr& entry);
  void takeActions(const mrpt::obs::CActionCollection& actions);
  void takeSensoryFrame(const mrpt::obs::CSensoryFrame& frame);
  void takeOdometry(const mrpt::obs::CObservation& observation);
  void takeObservation(const mrpt::obs::CObservation::Ptr& observation);
  void finishFrame(const mrpt::obs::CObservation2DRangeScan::Ptr& scan);
  double stampOf(const mrpt::obs::CObservation& observation);

  GzipInput file_;
  std::optional<std::string> sensorLabel_;
  std::deque<LaserFrame> frames_;  //!< complete frames that next() has not returned yet
  std::string damage_;
  std::map<std::string, int> scansOfSensors_;
  int entriesRead_ = 0;
  int stampsMadeUp_ = 0;

  // Parts of the next frame, which is not complete yet.
  mrpt::obs::CSensoryFrame observations_;
  mrpt::Clock::time_point actionTime_ = INVALID_TIMESTAMP;

  double lastStamp_s_ = 0;
  MotionBetweenScans motion_;
};
}  // namespace psmks
