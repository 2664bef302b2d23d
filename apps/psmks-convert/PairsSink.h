/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-convert/LogSink.h>
#include <psmks/eval/PairsFile.h>
#include <psmks/eval/StampIndex.h>
#include <psmks/mrpt/Convert.h>

#include <optional>
#include <string>
#include <vector>

namespace psmks
{
/** Writes consecutive scans as pairs with their true motion. */
class PairsSink : public LogSink
{
 public:
  /** @param every one of so many scans is taken
   *  @throws ProgramError if the ground truth cannot be read */
  PairsSink(const std::string& path, const std::string& groundTruth, int every);

  void write(const LaserFrame& frame) override;
  std::string finish() override;

 private:
  /** A scan that was taken. */
  struct Taken
  {
    Scan scan;
    Pose2 T_robot_sensor;
    Pose2 T_world_true;
  };
  std::optional<Taken> taken(const LaserFrame& frame);
  void addPair(const Taken& current);

  std::string path_;
  Trajectory truth_;
  StampIndex truthIndex_;
  int every_;
  ScanConverter converter_;
  int frames_ = 0;
  std::optional<Taken> reference_;
  Pose2 odometry_;  //!< motion of the robot since the reference
  bool odometryIsWhole_ = true;
  PairsHeader header_;
  std::vector<ScanPair> pairs_;
  int withoutTruth_ = 0, withOtherRays_ = 0, withoutOdometry_ = 0;
};
}  // namespace psmks
