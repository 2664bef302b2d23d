/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/eval/Figure.h>

namespace psmks
{
/** The effect of wrong associations on the orientation search, on scans without noise from true
 * positions: Fig. 1 (c) and (d) of the paper. */
struct OrientationExperiment
{
  /** The errors over the heading for two pairs of scans: one without wrong associations, and the
   * one with the most. */
  Figure figure;

  /** The errors of the headings that searches over 20 degrees to either side find. */
  struct Misses
  {
    double mean_rad = 0;
    double max_rad = 0;
  };

  int pairs = 0;
  Misses similar;   //!< the search of the paper: similar segments, matching error
  Misses absolute;  //!< each ray with the one at its bearing within 1 m, absolute error
  Misses squared;   //!< the same pairs of rays, squared error
};

/** Casts pairs of scans in a cluttered room and searches the heading of each. */
OrientationExperiment orientationExperiment(unsigned seed);
}  // namespace psmks
