/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/base/OptionTable.h>
#include <psmks/geometry/Angle.h>

namespace psmks
{
enum class JointSolver
{
  GaussNewton,
  Ceres
};

/** Options of the joint scheme (docs/derivations.md): which starts are refined, how, and which pose
 * is accepted. docs/options.md lists ranges and meanings. */
struct JointOptions
{
  // Hypotheses
  double searchRadius_m = 1.3;            //!< of the translation search about the guess
  double searchAngle_rad = degToRad(60);  //!< of the rotation search about the guess
  double wideRadius_m = 5;                //!< of the search where the best pose is doubtful
  double wideAngle_rad = degToRad(120);
  int votedAngles = 4;           //!< peaks of the vote that are followed
  int refinedHypotheses = 8;     //!< starts that go through Gauss-Newton at most
  double confidentScore = 0.75;  //!< a score from which no further start is tried
  double agreedScore = 0.65;     //!< the same for a pose that a measured guess confirms
  // Refinement
  double distanceGate_m = 0.20;         //!< between associated lines, first association
  double angleGate_rad = degToRad(10);  //!< between associated lines, first association
  double kernelWidth = 3.0;             //!< standard deviations at which a line pair loses weight
  double singleRayWeight = 0.5;         //!< of unsegmented rays
  int reassociations = 3;               //!< rounds of a refinement, at most (Refinement::refine())
  int maxIterations = 10;               //!< Gauss-Newton steps per association
  double stopTranslation_m = 1e-4;
  double stopRotation_rad = degToRad(1e-3);
  JointSolver solver = JointSolver::GaussNewton;
  // Acceptance
  int minAssociations = 10;             //!< fewer associated rays fail
  double acceptScore = 0.4;             //!< a lower free-space score fails; PoseVerifier.h
  double weakDirectionSigma_m = 0.015;  //!< a direction known worse is flagged as weak
  double unobservableSigma_m = 0.05;    //!< along a direction known worse, the guess is kept
  double weakHeadingSigma_rad = degToRad(1.0);
};

void listFields(OptionTable& table, JointOptions& options);
}  // namespace psmks
