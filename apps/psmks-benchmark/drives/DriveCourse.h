/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-benchmark/experiments/MethodRun.h>
#include <apps/support/SlamOptions.h>

#include <functional>
#include <vector>

namespace psmks
{
/** A part of a drive. */
struct DriveStretch
{
  double way_m = 0;           //!< true length of the path up to its end
  std::size_t scans = 0;      //!< in this part
  std::size_t keyframes = 0;  //!< of the whole map at its end
  double scan_s = 0;          //!< mean time of a scan, without output
  double memory_MB = 0;       //!< that the process has taken since the first scan of the drive
};

/** How a drive through a simulated world went. */
struct DriveCourse
{
  std::vector<DriveStretch> tenths;  //!< ten, of equally many scans
  DriftFigures drift;                //!< errors of the settled poses, the start given
  DriftFigures floor;  //!< the same if each match had the error of maximum likelihood, see
                       //!< DriftBound
  std::size_t segmentsOffWalls = 0;  //!< of the map, 30 cm or more from any wall: people, and what
                                     //!< is drawn in a wrong place
  std::size_t wrongLinks = 0;        //!< that pull a keyframe away from where it was

  /** The time of a scan in the last tenth over that in the first one. */
  double slowdown() const { return tenths.back().scan_s / tenths.front().scan_s; }
};

/** Follows the robot of a drive. A link is wrong that is more than 10 cm or 2 degrees off, and by
 * more than five standard deviations of what it claims.
 *  @param drive at least ten scans
 *  @param progress called with the share of the scans that are done, 0 to 1 */
DriveCourse followDrive(const Drive& drive, const SlamOptions& options,
                        const std::function<void(double)>& progress);
}  // namespace psmks
