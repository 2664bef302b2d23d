/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/PairsFile.h>
#include <psmks/eval/PairsSummary.h>

namespace psmks::test
{
/** A pair whose current scan is that of the reference, 1 m to the left of it.
 *
 *     .  .  .     three rays: to the right, ahead, to the left
 *      \ | /      each 2 m */
inline ScanPair forkPair(int id)
{
  ScanPair pair;
  pair.id = id;
  pair.T_ref_cur_true = {0, 1, 0};
  pair.reference.grid = BeamGrid::centered(kPi / 2, 3);
  pair.reference.range_m = {2, 2, 2};
  pair.current = pair.reference;
  return pair;
}

/** A match that ended a distance to the right of the truth. */
inline PairRecord matched(int id, double error_m, double error_deg = 0)
{
  PairRecord record;
  record.id = id;
  record.T_ref_cur_true = {0, 1, 0};
  record.result.T_ref_cur = {0, 1 - error_m, degToRad(error_deg)};
  record.result.status = MatchStatus::Converged;
  record.time_s = 1e-3;
  return record;
}
}  // namespace psmks::test
