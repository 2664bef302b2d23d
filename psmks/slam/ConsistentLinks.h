/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/slam/PosedScan.h>

#include <vector>

namespace psmks
{
/** Of the matches of a scan against keyframes, those that a second witness confirms.
 *
 * Each match corrects the pose that the map gives the scan. Two corrections agree where they are
 * less than 5 cm and 1 degree apart. A match is consistent if its correction agrees with none at
 * all, which is the map's own word, or with the correction of another match: a loop that closes
 * moves the scan by the same correction against all old keyframes, while a wrong match stands
 * alone.
 *
 * Source: the idea of pairwise consistent measurement set maximisation (Mangelson et al., ICRA
 * 2018), with fixed limits in place of a test by the covariances, and one witness in place of the
 * largest clique.
 *
 *  @param current a scan with the pose that the map gives it
 *  @param found matches of this scan; `reference` is an index into `scans`
 *  @return in their order */
std::vector<ReferenceMatch> consistentLinks(const std::vector<PosedScan>& scans,
                                            const PosedScan& current,
                                            const std::vector<ReferenceMatch>& found);
}  // namespace psmks
