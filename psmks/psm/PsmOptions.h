/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Angle.h>

namespace psmks
{
/** How PsmMatcher measures the difference of two matched scans. */
enum class PsmErrorIndex
{
  RangeDifference,  //!< fast: mean absolute range difference of the paired rays
  NearestPoint      //!< slow: mean distance to the nearest point, the worse of both directions
};

/** The constants of polar scan matching. The defaults are those that the authors use for a SICK
 * LMS200, which has 181 rays 1 degree apart.
 *
 *  Source: A. Diosi and L. Kleeman, "Laser scan matching in polar coordinates with application to
 *  SLAM", IROS 2005, and "Fast laser scan matching using polar coordinates", IJRR 26(10), 2007.
 *
 *  Quantities that the authors count in rays are angles here, so that they mean the same on every
 *  BeamGrid. Only the median window is a number of rays, for it removes single bad readings. */
struct PsmOptions
{
  // Preprocessing
  int medianWindow = 5;         //!< rays, odd; 1 = no filter
  double maxRange_m = 0;        //!< farther readings are ignored; 0 = the maximum of the scanner
  double segmentBreak_m = 0.2;  //!< neighbouring ranges farther apart are on two surfaces

  // Orientation search
  double searchWindow_rad = degToRad(20);  //!< to either side

  // Pairs of rays in the translation step
  double minProjectedRange_m = 0.1;
  double maxPairDifference_m = 1;  //!< largest difference of two paired ranges
  /** Least number of pairs times increment; 40 rays of 1 degree. */
  double minPairedArc_rad = degToRad(40);

  // Weights C / (d^2 + C) of a range difference d (Dudek and Jenkin), by the root of C
  double weightScale_m = 0.7;
  double lateWeightScale_m = 0.1;  //!< 70 cm / sqrt(50)
  int lateFromIteration = 10;      //!< counted from 0

  // Alternation. A step is small if |dx| + |dy| and |dphi|, each divided by its limit, sum up to
  // less than 1. (The authors add centimetres to an angle and compare the sum with 0.4.)
  int maxIterations = 30;  //!< orientation and translation steps are counted alike
  int smallStepsToStop = 3;
  double stopTranslation_m = 0.004;
  double stopRotation_rad = degToRad(0.4);

  // Error index and covariance
  PsmErrorIndex errorIndex = PsmErrorIndex::RangeDifference;
  double roomPositionSigma_m = 0.2;
  double alongCorridorSigma_m = 4;
  double acrossCorridorSigma_m = 0.3;
  double headingSigma_rad = degToRad(4);
  double errorOffset_m = 0.05;  //!< up to this plus one step the covariance is not enlarged
  double errorStep_m = 0.01;    //!< the covariance is enlarged in proportion to these steps

  // Corridor test
  /** A smaller spread of the directions of surfaces is a corridor. */
  double corridorSpread_rad = degToRad(25);
  double chordArc_rad = degToRad(1);  //!< angle between the ends of a chord; 1 ray of an LMS200
};
}  // namespace psmks
