/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <psmks/core/Pose2.h>
#include <psmks/mrpt/GzipInput.h>
#include <psmks/mrpt/OdometryTrack.h>

#include <deque>
#include <map>
#include <optional>
#include <string>

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

  /** Everything observed since the frame before, this scan included, odometry left out. */
  mrpt::obs::CSensoryFrame observations;
};

/** Reads the scans of one sensor from an MRPT rawlog, gzipped or not, of either kind: actions and
 *  sensory frames, or loose observations.
 *
 * Nothing here throws for a damaged file: what stands before the damage is read, then next() ends
 * and damage() says what happened. */
class RawlogReader
{
 public:
  /** @param sensorLabel the sensor to read; none: that of the first scan in the log */
  explicit RawlogReader(const std::string& path,
                        std::optional<std::string> sensorLabel = std::nullopt);

  /** The next scan; false at the end of the log or of what can be read of it. */
  bool next(LaserFrame& frame);

  /** Why the log ended before its end, as half a sentence: "read 12 entries, then: ..."; empty for
   * a whole log. */
  const std::string& damage() const { return damage_; }

  /** Entries of the log read so far, of whatever class. */
  int entriesRead() const { return entriesRead_; }

  /** The sensor that is read; none before the first scan unless one was asked for. */
  const std::optional<std::string>& sensorLabel() const { return sensorLabel_; }

  /** How many 2D scans of which sensor were met so far. */
  const std::map<std::string, int>& scansOfSensors() const { return scansOfSensors_; }

  /** Scans whose time had to be made up: neither they nor their actions have a stamp. */
  int stampsMadeUp() const { return stampsMadeUp_; }

  /** For progress bars, 0 to 1. */
  double shareRead() const { return file_.shareRead(); }

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
  std::optional<Pose2> odometryUntil(double stamp_s);

  GzipInput file_;
  std::optional<std::string> sensorLabel_;
  std::deque<LaserFrame> frames_;  //!< complete, not yet handed out
  std::string damage_;
  std::map<std::string, int> scansOfSensors_;
  int entriesRead_ = 0;
  int stampsMadeUp_ = 0;

  // Of the frame that is being put together.
  mrpt::obs::CSensoryFrame observations_;
  std::optional<Pose2> actionIncrement_;
  mrpt::Clock::time_point actionTime_ = INVALID_TIMESTAMP;

  double lastStamp_s_ = 0;
  bool actionsSeen_ = false;
  OdometryTrack track_;
  std::optional<Pose2> trackAtLastFrame_;
};
}  // namespace psmks
