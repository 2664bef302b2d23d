/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/support/CommandLineSyntax.h>

#include <optional>
#include <string>

namespace psmks
{
/** The values of the flags of psmks-simulate. */
struct CommandLine
{
  std::string world;
  std::optional<double> resolution_m;  //!< size of a pixel if the world is an image
  std::optional<double> startX_m, startY_m, startPhi_deg;
  int people = 0;

  std::string driver;  //!< empty: follows the route if there is one
  std::string route;   //!< empty: that of the world
  double minutes = 10;
  unsigned seed = 1;
  double wheelNoise = 0.05;

  int rays = 181;
  double fieldOfView_deg = 180;
  double maxRange_m = 30;
  double rangeSigma_m = 0.01;
  double quantum_m = 0;
  double dropOutShare = 0;
  double beamDivergence_deg = 0;
  double sweep_s = 0;
  int interleavedTurns = 1;
  double laserX_m = 0, laserY_m = 0, laserPhi_deg = 0;

  std::string output;
  std::string format = "actions";
  bool overwrite = false;
  bool listWorlds = false;
};

/** The flags of psmks-simulate. */
CommandLineSyntax<CommandLine> commandLineSyntax();
}  // namespace psmks
