/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/Figure.h>

namespace psmks
{
/** What bad associations do to the orientation search, on exact scans from true positions: the
 * paper's Fig. 1 (c) and (d). */
struct OrientationExperiment
{
  /** The error over the heading for two pairs of scans: one without bad associations and the one
   * with most of them. */
  Figure figure;

  /** How far from the true heading searches over 20 degrees to either side end. */
  struct Misses
  {
    double mean_rad = 0;
    double max_rad = 0;
  };

  int pairs = 0;
  Misses similar;   //!< the paper's search: similar segments, matching error
  Misses absolute;  //!< every ray with the one at its bearing within 1 m, absolute error
  Misses squared;   //!< the same, squared error
};

/** Casts pairs of scans in a cluttered room and searches the heading of each. */
OrientationExperiment orientationExperiment(unsigned seed);
}  // namespace psmks
