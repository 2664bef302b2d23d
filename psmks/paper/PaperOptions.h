/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/base/OptionTable.h>
#include <psmks/geometry/Angle.h>

namespace psmks
{
/** The Jacobian of the translation regression. */
enum class TranslationJacobian
{
  FrozenBearing,  //!< the paper's: (cos b, sin b), as if a ray kept its bearing
  Full            //!< (cos phi0, sin phi0) / cos(b - phi0): the bearing changes with the position
};

/** The heading of the current scan at which the angle gate of an association is tested. */
enum class GateOrientation
{
  Prior,  //!< the heading before the search stage
  Tested  //!< each heading that the search tries
};

enum class TranslationSolver
{
  ClosedForm,
  Ceres
};

/** The options of the scheme of the paper (section 2): association, orientation search, translation
 * regression. */
struct PaperOptions
{
  double radiusGate_m = 0.20;
  double angleGate_rad = degToRad(5);
  double mahalanobisGate = 0;  //!< 0 = off, as in the paper
  GateOrientation gateOrientation = GateOrientation::Tested;
  int minAssociations = 30;
  /** Poses with a smaller share of another's associations are never better; 0 = off. */
  double minAssociationShare = 0.9;
  double coarseRange_rad = degToRad(20);
  double coarseStep_rad = degToRad(1);
  double fineRange_rad = degToRad(1);
  double fineStep_rad = degToRad(0.1);
  /** A match with a larger root mean square of residuals fails; 0 = off. */
  double maxResidual_m = 0.05;
  TranslationJacobian jacobian = TranslationJacobian::FrozenBearing;
  TranslationSolver translationSolver = TranslationSolver::ClosedForm;
  /** How often a translation step is halved in search of a better one; 0 = never. */
  int stepHalvings = 3;
  int maxIterations = 30;
  double stopTranslation_m = 1e-3;
  double stopRotation_rad = degToRad(0.05);
  /** A direction with a larger standard deviation is unobservable. */
  double weakDirectionSigma_m = 0.05;
  double weakHeadingSigma_rad = degToRad(1.0);
};

void listFields(OptionTable& table, PaperOptions& options);
}  // namespace psmks
