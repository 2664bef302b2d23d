/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/maps/CSimpleMap.h>
#include <psmks/logs/RawlogReader.h>
#include <psmks/slam/TrajectoryBuilder.h>

#include <string>

namespace psmks
{
/** Adds a scan with its observations and its pose to a map of key frames, for MRPT's map builders.
 */
void addKeyframe(const PosedScan& scan, const LaserFrame& frame, mrpt::maps::CSimpleMap& map);

/** A rawlog of actions and sensory frames whose motions are those of scan matching, with their
 *  covariances: every MRPT program that reads odometry from a rawlog takes them for it.
 * Observations stay as they were; an odometry among them is left out. */
class MatchedRawlog
{
 public:
  /** False where the file could not be created. */
  bool open(const std::string& path) { return file_.open(path); }

  /** Scans in their order, each with the frame it came from. */
  void write(const PosedScan& scan, const LaserFrame& frame);

 private:
  mrpt::io::CFileGZOutputStream file_;
};
}  // namespace psmks
