/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/slam/G2oFile.h>

#include <limits>
#include <ostream>

namespace psmks
{
namespace
{
void writePose(std::ostream& out, const Pose2& pose)
{
  out << pose.x_m << ' ' << pose.y_m << ' ' << pose.phi_rad;
}

/** The information of a link in the axes of the measured pose, in which g2o takes the error. */
Eigen::Matrix3d informationSeenFromTo(const PoseLink& link, double weight)
{
  /** Information in directions that a link leaves open. Unit: 1/m^2 and 1/rad^2. Definition: that
   * of a standard deviation of 100 m, for gtsam takes no matrix that is singular. */
  constexpr double kLeast = 1e-4;
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  R.topLeftCorner<2, 2>() = link.T_from_to.rotation();
  return weight * R.transpose() * link.information * R + kLeast * Eigen::Matrix3d::Identity();
}

void writeUpperTriangle(std::ostream& out, const Eigen::Matrix3d& matrix)
{
  for (Eigen::Index row = 0; row < 3; ++row)
    for (Eigen::Index column = row; column < 3; ++column) out << ' ' << matrix(row, column);
}
}  // namespace

void writeG2o(std::ostream& out, const PoseGraph& graph, const std::vector<std::size_t>& names)
{
  out.precision(std::numeric_limits<double>::max_digits10);
  for (std::size_t node = 0; node < names.size(); ++node)
  {
    out << "VERTEX_SE2 " << names[node] << ' ';
    writePose(out, graph.poses()[node]);
    out << '\n';
  }
  for (const PoseLink& link : graph.links())
  {
    out << "EDGE_SE2 " << names[link.from] << ' ' << names[link.to] << ' ';
    writePose(out, link.T_from_to);
    writeUpperTriangle(out, informationSeenFromTo(link, graph.weight(link)));
    out << '\n';
  }
}
}  // namespace psmks
