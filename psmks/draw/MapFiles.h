/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/serialization/CSerializable.h>
#include <psmks/gzip/GzipOutput.h>
#include <psmks/logs/RawlogReader.h>
#include <psmks/slam/TrajectoryBuilder.h>

#include <string>

namespace psmks
{
/** Adds a scan with its observations and its pose to a map of key frames for MRPT's map builders.
 */
void addKeyframe(const PosedScan& scan, const LaserFrame& frame, mrpt::maps::CSimpleMap& map);

/** Writes an object of MRPT, gzipped, as the function saveToFile() of such objects does, which
 * tells no error of the last bytes.
 *  @return false if any byte could not be written */
bool saveObject(const mrpt::serialization::CSerializable& object, const std::string& path);

/** Writes a rawlog of actions and sensory frames in which the motions of scan matching, with their
 * covariances, take the place of odometry. MRPT programs that read odometry from a rawlog then use
 * the matched motions. Observations stay as they are, except that odometry among them is left out.
 */
class MatchedRawlog
{
 public:
  /** Creates the file.
   *  @return false if it cannot be created */
  bool open(const std::string& path) { return file_.open(path, GzipUse::Always); }

  /** Appends a scan with the frame of the log that it came from. Scans have to come in their order.
   */
  void write(const PosedScan& scan, const LaserFrame& frame);

  /** Closes the file.
   *  @return false if any byte could not be written */
  bool close() { return file_.close(); }

 private:
  GzipOutput file_;
};
}  // namespace psmks
