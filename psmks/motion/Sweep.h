/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Scan.h>

#include <deque>

namespace psmks
{
/** Turns the rays of a scan into the frame that the sensor had when the first of them was measured.
 *
 * While the beam sweeps, a robot that turns carries it on: the ray that the scanner calls b was
 * cast at b + rate * time since the first ray. For a steady rate that is an even grid again, whose
 * increment is wider where robot and beam turn the same way.
 *
 *     a scanner that takes 7 ms for 180 degrees on a robot that turns with 60 degrees a second
 *     reports a half circle of 180 degrees where it swept 180.4
 *
 * Uncorrected, every turn is measured too small if the robot turns with the beam and too large if
 * against it: a heading error that grows with the turns made, always to the same side. What the
 * robot moves during a sweep is not corrected. Rays of a scanner that would go more than once round
 * are dropped at the end. Does nothing where the duration is unknown or a value is not finite. */
void straightenSweep(Scan& scan, double turnRate_rad_s);

/** From the first to the last ray of a scanner whose beam goes once round in a time. */
double sweepDuration_s(const BeamGrid& grid, double beamTurn_s);

/** How fast a robot turns, from its headings at the times of its scans.
 *
 * The rate is that over the last kWindow_s at least: stamps of single scans jitter. */
class TurnRate
{
 public:
  static constexpr double kWindow_s = 0.2;
  static constexpr double kMaxAge_s = 3.0;  //!< a longer gap says nothing of the present

  /** @param turned_rad since the last call */
  void add(double stamp_s, double turned_rad);

  /** 0 where the readings do not tell: before the second one, after a gap, and where their stamps
   * do not increase. */
  double rate_rad_s() const;

 private:
  struct Reading
  {
    double stamp_s, heading_rad;
  };
  std::deque<Reading>
      readings_;  //!< the first is the youngest that is kWindow_s older than the last
};
}  // namespace psmks
