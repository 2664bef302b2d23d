/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/base/OptionTable.h>
#include <psmks/geometry/Angle.h>

namespace psmks
{
/** Jacobian of the translation regression. */
enum class TranslationJacobian
{
  FrozenBearing,  //!< the paper's: (cos b, sin b), as if a ray kept its bearing
  Full            //!< (cos phi0, sin phi0) / cos(b - phi0): the bearing changes with the position
};

/** The orientation at which the angle gate of an association is tested. */
enum class GateOrientation
{
  Prior,  //!< the orientation held before the search stage
  Tested  //!< each orientation that the search tries
};

enum class TranslationSolver
{
  ClosedForm,
  Ceres
};

/** The scheme of the paper (section 2): association, orientation search, translation regression. */
struct PaperOptions
{
  double radiusGate_m = 0.20;
  double angleGate_rad = degToRad(5);
  double mahalanobisGate = 0;  //!< 0 = off, as in the paper
  GateOrientation gateOrientation = GateOrientation::Tested;
  int minAssociations = 30;
  double minAssociationShare = 0.9;  //!< of another pose's, to compare by the error; 0 = any number
  double coarseRange_rad = degToRad(20);
  double coarseStep_rad = degToRad(1);
  double fineRange_rad = degToRad(1);
  double fineStep_rad = degToRad(0.1);
  double maxResidual_m = 0.05;  //!< a larger root mean square at the end fails; 0 = off
  TranslationJacobian jacobian = TranslationJacobian::FrozenBearing;
  TranslationSolver translationSolver = TranslationSolver::ClosedForm;
  int stepHalvings = 3;  //!< shorter translation steps that are tried too; 0 = none
  int maxIterations = 30;
  double stopTranslation_m = 1e-3;
  double stopRotation_rad = degToRad(0.05);
  double weakDirectionSigma_m = 0.05;  //!< a direction known worse is not observable
  double weakHeadingSigma_rad = degToRad(1.0);
};

void listFields(OptionTable& table, PaperOptions& options);
}  // namespace psmks
