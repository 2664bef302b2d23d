/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/slam/PosedScan.h>

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace psmks
{
/** Tells returns of things that came or went from those of things that stay: what one scan met and
 * two others at least looked through, more than met it too, has moved.
 *
 *     wall  -----------------      The scan from s met a person at p. The keyframes k1 and k2 saw
 *               .  |  .            the wall behind p: there was nobody then.
 *                . p .
 *               .  |  .
 *              k1  s   k2
 *
 * The witnesses are the nearest scans that served as references, each at its own time. One says
 * something of a return only where the rays that pass it are so close together that a leg would be
 * met, and where both of them met something. The poses of the scans must be settled, see
 * TrajectoryBuilder::optimise(). */
class MovingReturns
{
 public:
  /** @param scans kept by reference; each with as many ranges as rays, others have no returns */
  explicit MovingReturns(const std::vector<PosedScan>& scans);

  /** Flags the rays of a scan that met what has moved.
   *  @param index of the scan
   *  @return one flag for each ray, 0 or 1 */
  std::vector<std::uint8_t> of(std::size_t index) const;

 private:
  using Cell = std::pair<int, int>;

  std::vector<std::size_t> witnessesOf(std::size_t index) const;

  const std::vector<PosedScan>& scans_;
  std::map<Cell, std::vector<std::size_t>> references_;  //!< by the places of their scanners
};
}  // namespace psmks
