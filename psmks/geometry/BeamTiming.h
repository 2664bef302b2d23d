/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Scan.h>

namespace psmks
{
/** When a scanner casts its rays. */
struct BeamTiming
{
  /** Time of one turn of the beam, negative where it passes the rays from the last to the first; 0
   * = unknown. */
  double turn_s = 0;

  /** Angle between the rays of one turn. A scan whose rays lie closer was taken in several turns,
   * which interleave; 0 = a scan is always taken in one turn. */
  double turnIncrement_rad = 0;
};

/** The time from the first to the last ray of a scanner whose beam takes `beamTurn_s` for a full
 * circle. */
double sweepDuration_s(const BeamGrid& grid, double beamTurn_s);

/** States in a scan when its rays were cast. The number of its turns is that of its rays in one
 * angle between rays of a turn.
 *
 *     SICK LMS 200, 75 turns a second, 1 degree between the rays of a turn:
 *     increment    1 deg     0.5 deg            0.25 deg
 *     turns        1         2: 0, 1 | 0.5      4: 0, 1 | 0.25, 1.25 | 0.5, 1.5 | 0.75
 */
void setTiming(const BeamTiming& timing, Scan& scan);

/** The time from ray 0 of a scan to another ray: negative for rays that were cast earlier.
 *  @param ray within the grid */
double sinceFirstRay_s(const Scan& scan, int ray);

/** The time from the middle of a scan, between its first and last cast, to a ray.
 *  @param ray within the grid */
double sinceMiddle_s(const Scan& scan, int ray);

/** Of sinceMiddle_s(), what is due to the turn that the ray belongs to, and not to its place in the
 * sweep. */
double turnOffset_s(const Scan& scan, int ray);
}  // namespace psmks
