/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/support/CommandLineSyntax.h>
#include <apps/support/TableFiles.h>
#include <psmks/eval/RelationStatistics.h>
#include <psmks/geometry/Angle.h>

#include <string>
#include <vector>

namespace psmks
{
/** The values of the flags of psmks-evaluate. */
struct CommandLine
{
  std::vector<std::string> estimates;
  std::string groundTruth;  //!< empty: none, then there are relations
  std::string relations;    //!< empty: none, then there is a ground truth

  std::size_t skippedPoses = 0;  //!< first poses with a known truth that are left out
  PairError limit{0.15, degToRad(2)};
  std::vector<double> driftLengths_m{1, 10};
  double shortSpan_s = kShortSpan_s;

  std::string plot;  //!< empty: no picture
  TableFiles files;
};

/** The flags of psmks-evaluate. */
CommandLineSyntax<CommandLine> commandLineSyntax();
}  // namespace psmks
