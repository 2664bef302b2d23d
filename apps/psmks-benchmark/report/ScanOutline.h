/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Scan.h>

#include <Eigen/Core>
#include <string>
#include <vector>

namespace psmks
{
/** The end points of the rays with a return, in the sensor frame. */
std::vector<Eigen::Vector2d> returnPoints(const Scan& scan);

/** The returns of a scan as the data of an SVG path, in centimetres with y downwards. Neighbours
 * that may lie on one surface are joined. */
std::string outlinePath(const Scan& scan);
}  // namespace psmks
