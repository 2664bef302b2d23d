/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/geometry/BeamTiming.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
/** The turn in which a ray was cast, counted from 0 in the order of the beam. */
int turnOf(const Scan& scan, int ray)
{
  const int inOrder = scan.sweepDuration_s < 0 ? scan.grid.count() - 1 - ray : ray;
  return inOrder % std::max(1, scan.interleavedTurns);
}
}  // namespace

double sweepDuration_s(const BeamGrid& grid, double beamTurn_s)
{
  const double swept_rad = std::max(0, grid.count() - 1) * grid.increment_rad();
  return beamTurn_s * swept_rad / (2 * kPi);
}

void setTiming(const BeamTiming& timing, Scan& scan)
{
  scan.sweepDuration_s = sweepDuration_s(scan.grid, timing.turn_s);
  scan.turn_s = std::abs(timing.turn_s);
  const double turns = timing.turnIncrement_rad / scan.grid.increment_rad();
  scan.interleavedTurns = std::max(1, static_cast<int>(std::lround(turns)));
}

double turnOffset_s(const Scan& scan, int ray)
{
  const int turns = std::max(1, scan.interleavedTurns);
  return scan.turn_s * (turnOf(scan, ray) - (turns - 1) / 2.0);
}

double sinceMiddle_s(const Scan& scan, int ray)
{
  const double swept = static_cast<double>(ray) / std::max(1, scan.grid.count() - 1);
  return scan.sweepDuration_s * (swept - 1.0 / 2) + turnOffset_s(scan, ray);
}

double sinceFirstRay_s(const Scan& scan, int ray)
{
  return sinceMiddle_s(scan, ray) - sinceMiddle_s(scan, 0);
}
}  // namespace psmks
