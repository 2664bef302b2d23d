/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <mrpt/obs/CActionCollection.h>
#include <psmks/logs/LogReader.h>
#include <psmks/logs/RawlogEntries.h>
#include <psmks/motion/MotionBetweenScans.h>

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace psmks
{
/** Reads an MRPT rawlog, gzipped or not, of both kinds: actions and sensory frames, or single
 * observations. Scans with an absurd mounting and absurd motions are left out, see remarks().
 * Damage of the file ends the log where it is, see RawlogEntries. */
class RawlogReader : public LogReader
{
 public:
  /** @param sensorLabel the sensor to read; by default that of the first scan in the log */
  explicit RawlogReader(const std::string& path,
                        std::optional<std::string> sensorLabel = std::nullopt);

  bool next(LaserFrame& frame) override;
  std::vector<std::string> remarks() const override;
  const std::string& damage() const override { return entries_.damage(); }
  int entriesRead() const override { return entries_.read(); }
  const std::optional<std::string>& sensorLabel() const override { return sensorLabel_; }
  const std::map<std::string, int>& scansOfSensors() const override { return scansOfSensors_; }
  int stampsMadeUp() const override { return stampsMadeUp_; }
  double shareRead() const override { return entries_.shareRead(); }

 private:
  void take(const mrpt::serialization::CSerializable::Ptr& entry);
  void takeActions(const mrpt::obs::CActionCollection& actions);
  void takeSensoryFrame(const mrpt::obs::CSensoryFrame& frame);
  void takeOdometry(const mrpt::obs::CObservation& observation);
  void takeObservation(const mrpt::obs::CObservation::Ptr& observation);
  void finishFrame(const mrpt::obs::CObservation2DRangeScan::Ptr& scan);
  double stampOf(const mrpt::obs::CObservation& observation);

  RawlogEntries entries_;
  std::optional<std::string> sensorLabel_;
  std::deque<LaserFrame> frames_;  //!< complete frames that next() has not returned yet
  std::map<std::string, int> scansOfSensors_;
  int stampsMadeUp_ = 0;
  int absurdScans_ = 0, absurdMotions_ = 0;  //!< left out: not finite, or farther than a robot is

  // Parts of the next frame, which is not complete yet.
  mrpt::obs::CSensoryFrame observations_;
  mrpt::Clock::time_point actionTime_ = INVALID_TIMESTAMP;

  double lastStamp_s_ = 0;
  MotionBetweenScans motion_;
};
}  // namespace psmks
