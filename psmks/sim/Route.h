/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <Eigen/Core>
#include <iosfwd>
#include <vector>

namespace psmks
{
/** Points of the world frame, metres, that a robot is driven along, the first one its start. */
using Route = std::vector<Eigen::Vector2d>;

/** Reads a route: "x y" in metres a line; '#' begins a comment; empty lines are skipped.
 *  @throws std::runtime_error with the number of the line that is no point, and where there are
 *  fewer than two points */
Route readRoute(std::istream& in);
}  // namespace psmks
