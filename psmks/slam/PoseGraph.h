/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/Pose2.h>

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace psmks
{
/** A measured pose of one node seen from another. */
struct PoseLink
{
  std::size_t from = 0, to = 0;
  Pose2 T_from_to;
  Eigen::Matrix3d information;  //!< of (x, y, phi) in the axes of `from`
};

/** Poses that many measured differences between them fix together, by least squares.
 *
 *     0 ---- 1 ---- 2        node 0 stays where it was put; a link that contradicts the others
 *      \           /         counts less (Cauchy, 3 standard deviations), so that a wrong match
 *       5 --- 4 --3          does not bend the map. A new link counts in full at first: the drift
 *                            that a closed loop takes away contradicts it, too.               */
class PoseGraph
{
 public:
  /** @return its number, from 0 on */
  std::size_t add(const Pose2& guess);

  void add(const PoseLink& link) { links_.push_back(link); }

  /** Gauss-Newton from the present poses until the steps are small. A node that no link ties to a
   * fixed one, directly or not, stays where it is.
   *  @param firstFree nodes before it are fixed; at least node 0 is */
  void optimise(std::size_t firstFree = 1);

  const std::vector<Pose2>& poses() const { return poses_; }
  const std::vector<PoseLink>& links() const { return links_; }

 private:
  double step(std::size_t firstFree, bool trustNewLinks);

  std::vector<Pose2> poses_;
  std::vector<PoseLink> links_;
  std::size_t optimisedLinks_ = 0;  //!< the ones after them are new
};

/** Pose difference of a link's nodes minus what was measured, in the axes of `from`. */
Eigen::Vector3d linkError(const PoseLink& link, const Pose2& from, const Pose2& to);
}  // namespace psmks
