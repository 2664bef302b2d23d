/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/base/OptionTable.h>
#include <psmks/geometry/Angle.h>

namespace psmks
{
/** Which Kalman filter estimates the lines. */
enum class LineFilter
{
  Linear,  //!< LinearLineFilter, followed by one Gauss-Newton step
  Ekf      //!< the paper's PolarLineFilter
};

/** Which rays are valid. */
struct PreprocessingOptions
{
  double minRange_m = 0.0;  //!< readings at or below it are invalid
  double maxRange_m = 0.0;  //!< readings at or beyond it are invalid; 0 = the scan's own limit
  int medianWindow = 0;     //!< rays; 0 or 1 = off
};

/** Options of the Kalman Segmentation. docs/options.md has their ranges. */
struct SegmentationOptions
{
  /** Which filter grows the lines. */
  LineFilter filter = LineFilter::Linear;

  /** Standard deviation of a range, where the scan does not state its own. */
  double rangeSigma_m = 0.01;

  /** Growth of that standard deviation with the range, see RangeNoise. */
  double rangeSigmaPerMetre_m = 0;

  /** Whether the noise is raised to what the scan itself shows, see shownNoise() and
   * findRounding(). */
  bool estimateRangeSigma = true;

  /** Standard deviations within which a ray continues a line: chi2 with 1 degree of freedom at
   * 0.999. */
  double innovationGate = 3.3;

  /** Consecutive rays that start a line. */
  int seedRays = 4;

  /** Fewest rays of a segment. */
  int minRays = 6;

  /** Rays on either side of a corner for which the two lines compete. */
  int cornerReach = 8;

  /** Rise of chi2, with 2 degrees of freedom, below which touching lines merge. */
  double mergeChi2 = 11.2;

  /** Chi2 per degree of freedom above which rays are too noisy for a segment. */
  double maxReducedChi2 = 3.0;

  /** Standard deviations of the quadratic term above which rays are a curve and no segment. */
  double curvatureGate = 4.5;

  /** Smallest cosine of incidence of the end rays of a segment. Below it the errors of bearings
   * dominate. */
  double minIncidenceCosine = 0.05;

  /** Largest standard deviation of the distance of a segment's line at its best known point. */
  double maxOffsetSigma_m = 0.10;

  /** Largest standard deviation of the angle of a segment's line. */
  double maxAngleSigma_rad = degToRad(11.5);
};

/** Adds the options to a table with their keys, units, ranges and descriptions. */
void listFields(OptionTable& table, PreprocessingOptions& options);
void listFields(OptionTable& table, SegmentationOptions& options);
}  // namespace psmks
