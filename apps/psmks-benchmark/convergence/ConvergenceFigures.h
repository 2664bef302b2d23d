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
/** Success in percent: a row for each matcher and rotation, a column for each distance. */
Table convergenceTable(const std::string& title, const ConvergenceGrid& grid,
                       const std::vector<ConvergenceMap>& maps);

/** Success in percent over distance and rotation; the title says the mean of all cells, too. */
HeatMap convergencePicture(const std::string& title, const ConvergenceGrid& grid,
                           const ConvergenceMap& map);

/** A picture for each matcher, named by it. */
std::vector<Panel> convergencePictures(const ConvergenceGrid& grid,
                                       const std::vector<ConvergenceMap>& maps);
}  // namespace psmks
