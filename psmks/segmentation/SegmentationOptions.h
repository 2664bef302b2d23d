/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/base/OptionTable.h>
#include <psmks/geometry/Angle.h>

namespace psmks
{
/** Which filter estimates a segment's (r0, phi0). */
enum class LineFilter
{
  Linear,  //!< information form of the exactly linear 1/r = u.(cos, sin), finished by Gauss-Newton
  Ekf      //!< the paper's extended Kalman filter on (r0, phi0)
};

/** What counts as a valid ray. */
struct PreprocessingOptions
{
  double minRange_m = 0.0;  //!< readings at or below it are invalid
  double maxRange_m = 0.0;  //!< readings at or beyond it are invalid; 0 = the scan's own limit
  int medianWindow = 0;     //!< rays; 0 or 1 = off
};

/** Kalman Segmentation. */
struct SegmentationOptions
{
  LineFilter filter = LineFilter::Linear;
  double rangeSigma_m = 0.01;       //!< used where the scan does not state its own
  double rangeSigmaPerMetre_m = 0;  //!< its growth, see RangeNoise
  bool estimateRangeSigma = true;   //!< raise the sigma to what the scan itself shows
  double innovationGate = 3.3;      //!< standard deviations; chi2(1) at 0.999
  int seedRays = 4;
  int minRays = 6;
  int cornerReach = 8;      //!< rays on either side over which a corner is contested
  double mergeChi2 = 11.2;  //!< rise of chi2 (2 degrees of freedom) below which neighbours merge
  double maxReducedChi2 = 3.0;       //!< above it the rays are too noisy or curved for a segment
  double curvatureGate = 4.5;        //!< standard deviations of the quadratic term
  double minIncidenceCosine = 0.05;  //!< |cos(bearing - phi0)| below it: bearing errors dominate
  double maxOffsetSigma_m = 0.10;    //!< of the line at its middle
  double maxAngleSigma_rad = degToRad(11.5);
};

void listFields(OptionTable& table, PreprocessingOptions& options);
void listFields(OptionTable& table, SegmentationOptions& options);
}  // namespace psmks
