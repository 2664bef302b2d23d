/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <apps/psmks-benchmark/convergence/Convergence.h>
#include <psmks/eval/Figure.h>
#include <psmks/eval/HeatMap.h>
#include <psmks/eval/Table.h>

#include <string>
#include <vector>

namespace psmks
{
/** The successes in percent, with a row for each matcher and rotation and a column for each
 * distance. */
Table convergenceTable(const std::string& title, const ConvergenceGrid& grid,
                       const std::vector<ConvergenceMap>& maps);

/** The successes in percent over distance and rotation. The title also has the mean of all cells.
 */
HeatMap convergencePicture(const std::string& title, const ConvergenceGrid& grid,
                           const ConvergenceMap& map);

/** A picture for each matcher, with the name of the matcher as its title. */
std::vector<Panel> convergencePictures(const ConvergenceGrid& grid,
                                       const std::vector<ConvergenceMap>& maps);
}  // namespace psmks
