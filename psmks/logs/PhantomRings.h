/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <mrpt/obs/CObservation2DRangeScan.h>

#include <vector>

namespace psmks
{
/** Ranges that stand for something else than a surface. */
struct RangeBand
{
  double from_m = 0, to_m = 0;
  int readings = 0;

  bool contains(double range_m) const { return range_m >= from_m && range_m <= to_m; }
};

/** Finds readings that many scanners and drivers give for "no return" without saying so: a value
 * just below the greatest range, or several, constant or scattered over some decimetres. As
 * surfaces they would be rings about the scanner that move with it, and so would be parts of the
 * robot in the view of its scanner.
 *
 *     readings |              #
 *              |              #          such a band has ten times as many readings as any other of
 *              | # # #        #          its width beside it, and covers more bearings of a scan
 * than
 *              |# # # # # # # # # #      a flat wall at its range could
 *              +--------------#---> range
 *
 * A band is at most a twentieth of its range wide. A wall that a robot follows at a constant
 * distance r has readings between r and r + w at no more than 2 sqrt(2 w / r) of the bearings, and
 * a third as many between r + 2 w and r + 3 w. */
class PhantomRings
{
 public:
  /** Counts the valid readings of a scan below its greatest range. */
  void add(const mrpt::obs::CObservation2DRangeScan& scan);

  /** The bands of all scans so far, the nearest first, none that overlap; none before 20 scans, and
   * none where they would hold all readings. */
  std::vector<RangeBand> bands() const;

 private:
  double countBetween(std::size_t first, std::size_t last) const;
  bool standsOut(std::size_t first, std::size_t width) const;
  bool holdsAll(const std::vector<bool>& isTaken) const;

  std::vector<double> centimetres_;  //!< number of readings by range
  double readings_ = 0;
  double bearings_rad_ = 0;  //!< of all scans together
  int scans_ = 0;
};
}  // namespace psmks
