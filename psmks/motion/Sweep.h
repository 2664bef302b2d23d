/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Scan.h>

#include <deque>

namespace psmks
{
/** Corrects the bearings of a scan for the rotation of the robot during the sweep of the beam, so
 * that all of them are in the frame that the sensor had at the first ray.
 *
 * A ray that the scanner reports at bearing b was cast at b + rate * (time since the first ray).
 * For a steady rate the true bearings are an even grid again, with a wider increment where robot
 * and beam turn the same way.
 *
 *     A scanner that takes 7 ms for 180 degrees, on a robot that turns with 60 degrees a second,
 *     reports a half circle of 180 degrees where it swept 180.4 degrees.
 *
 * Without the correction every turn is measured too small if the robot turns with the beam and too
 * large if it turns against it, an error of the heading that adds up to the same side. Translation
 * during the sweep is not corrected. Where the corrected rays would cover more than a full circle,
 * the last rays are dropped. The scan stays as it is where its sweepDuration_s is 0 (unknown),
 * where the rate is not finite, and where it has not as many ranges as rays.
 *
 *  @param turnRate_rad_s of the robot, positive to the left */
void straightenSweep(Scan& scan, double turnRate_rad_s);

/** The time from the first to the last ray of a scanner whose beam takes `beamTurn_s` for a full
 * circle. */
double sweepDuration_s(const BeamGrid& grid, double beamTurn_s);

/** How fast a robot turns, from what it turned between its scans. The rate is a mean over at least
 * the last kWindow_s, since the stamps of single scans jitter. */
class TurnRate
{
 public:
  /** Time over which the rate is measured, at least. Evidence: measured. */
  static constexpr double kWindow_s = 0.2;

  /** Gap between scans from which on the rate is unknown. Evidence: measured. */
  static constexpr double kMaxAge_s = 3.0;

  /** Adds a reading. One that goes back in time replaces all before it; one that is not finite
   *  removes them.
   *  @param turned_rad by how much the robot has turned since the reading before */
  void add(double stamp_s, double turned_rad);

  /** The rate, positive to the left; 0 where it is not known: before the second reading, where the
   * readings span less than a quarter of kWindow_s, and where they span more than kMaxAge_s. */
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
