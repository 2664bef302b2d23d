/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/logs/LogReader.h>
#include <psmks/mrpt/Convert.h>

#include <cstdlib>

namespace psmks::test
{
/** Reads a log to its end or to its damage. Aborts where a mounting or an odometry is not finite,
 * or where damage is told in more than 400 characters. */
inline void readWhole(LogReader& reader)
{
  ScanConverter converter;
  for (LaserFrame frame; reader.next(frame);)
  {
    converter.convert(*frame.scan);
    const Pose2 mounting = sensorMounting(*frame.scan).T_robot_sensor;
    if (!mounting.isFinite() || (frame.odometry && !frame.odometry->isFinite())) std::abort();
  }
  reader.remarks();
  if (reader.damage().size() > 400) std::abort();
}
}  // namespace psmks::test
