/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <mrpt/core/Clock.h>
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/io/CFileOutputStream.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/serialization/CArchive.h>
#include <psmks/mrpt/Convert.h>
#include <tests/unit/mrpt/Observation.h>

#include <string>
#include <vector>

namespace psmks::test
{
/** What a robot saw of the office room on an arc, with odometry that turns too little.
 *
 *     +------+---------+
 *     |      |  ___    |      start at the origin, facing +x, 10 cm and 5 degrees a step
 *     |  o-->_   \__\  |
 *     |       \        |
 *     +----------------+                                                                    */
struct RoomLog
{
  struct Step
  {
    double stamp_s;
    Pose2 T_world_robot, T_odom_robot;
    Pose2 odometryIncrement;
    mrpt::obs::CObservation2DRangeScan::Ptr scan;
  };

  std::vector<Step> steps;

  explicit RoomLog(int scans = 8)
  {
    constexpr double kFirstStamp_s = 1.6e9, kPeriod_s = 0.25;
    const Pose2 trueStep{0.10, 0, degToRad(5)}, measuredStep{0.105, 0, degToRad(4)};
    Scanner scanner;
    scanner.sensorPose = mrpt::poses::CPose3D(0.2, 0.1, 0.3, degToRad(10), 0, 0);
    Step step{kFirstStamp_s, {}, {}, {}, nullptr};
    for (int i = 0; i < scans; ++i)
    {
      step.scan = mrpt::obs::CObservation2DRangeScan::Create(
          observe(officeRoom(), toMrpt(step.T_world_robot), scanner));
      step.scan->timestamp = mrpt::Clock::fromDouble(step.stamp_s);
      step.scan->sensorLabel = "FRONT";
      steps.push_back(step);
      step.stamp_s += kPeriod_s;
      step.T_world_robot = step.T_world_robot * trueStep;
      step.T_odom_robot = step.T_odom_robot * measuredStep;
      step.odometryIncrement = measuredStep;
    }
  }
};

/** The entries of a rawlog, in their order. */
using Entries = std::vector<mrpt::serialization::CSerializable::Ptr>;

inline mrpt::obs::CActionCollection::Ptr makeActions(const RoomLog::Step& step)
{
  mrpt::obs::CActionRobotMovement2D motion;
  motion.timestamp = mrpt::Clock::fromDouble(step.stamp_s);
  motion.computeFromOdometry(toMrpt(step.odometryIncrement), {});
  auto actions = mrpt::obs::CActionCollection::Create();
  actions->insert(motion);
  return actions;
}

inline mrpt::obs::CObservationOdometry::Ptr makeOdometry(const RoomLog::Step& step)
{
  auto odometry = mrpt::obs::CObservationOdometry::Create();
  odometry->timestamp = mrpt::Clock::fromDouble(step.stamp_s);
  odometry->sensorLabel = "ODOMETRY";
  odometry->odometry = toMrpt(step.T_odom_robot);
  return odometry;
}

/** The log with alternating actions and sensory frames. */
inline Entries asFrames(const RoomLog& log)
{
  Entries entries;
  for (const auto& step : log.steps)
  {
    auto frame = mrpt::obs::CSensoryFrame::Create();
    frame->insert(step.scan);
    entries.push_back(makeActions(step));
    entries.push_back(frame);
  }
  return entries;
}

/** The log with single observations: odometry and a scan of the same stamp alternate. */
inline Entries asObservations(const RoomLog& log)
{
  Entries entries;
  for (const auto& step : log.steps)
  {
    entries.push_back(makeOdometry(step));
    entries.push_back(step.scan);
  }
  return entries;
}

template <class File>
void writeRawlog(const Entries& entries, const std::string& path)
{
  File file(path);
  auto archive = mrpt::serialization::archiveFrom(file);
  for (const auto& entry : entries) archive << *entry;
}

inline void writeGzipped(const Entries& entries, const std::string& path)
{
  writeRawlog<mrpt::io::CFileGZOutputStream>(entries, path);
}

inline void writePlain(const Entries& entries, const std::string& path)
{
  writeRawlog<mrpt::io::CFileOutputStream>(entries, path);
}
}  // namespace psmks::test
