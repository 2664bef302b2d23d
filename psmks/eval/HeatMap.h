/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace psmks
{
/** Values over a grid of two variables, as coloured cells with numbers in them and a colour bar.
 *
 *     y[1] | value(1,0) value(1,1) value(1,2)
 *     y[0] | value(0,0) value(0,1) value(0,2)
 *          +---- x[0] ----- x[1] ----- x[2] --    Cells meet halfway between their centres. */
struct HeatMap
{
  std::string title;
  std::string xLabel, yLabel, valueLabel;  //!< with units
  std::vector<double> x, y;  //!< centres of the cells, increasing; at least one on each axis
  Eigen::MatrixXd value;     //!< y.size() x x.size(); NaN = an empty cell
  double valueMin = 0, valueMax = 1;  //!< ends of the colour range
  int decimals = 0;                   //!< digits after the point of the numbers in the cells
};
}  // namespace psmks
