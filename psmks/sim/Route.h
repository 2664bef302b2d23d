/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <Eigen/Core>
#include <iosfwd>
#include <vector>

namespace psmks
{
/** The points, in metres in the frame of the world, that a robot is driven along. It starts at the
 * first one. */
using Route = std::vector<Eigen::Vector2d>;

/** Reads a route from a text with a point "x y" in metres on each line. A comment begins with '#'
 * and ends with its line; blank lines are skipped.
 *  @throws std::runtime_error if a line is not a point, naming the line, or if there are fewer than
 *          two points */
Route readRoute(std::istream& in);
}  // namespace psmks
