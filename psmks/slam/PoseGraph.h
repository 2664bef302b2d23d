/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/geometry/UncertainPose.h>

#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <vector>

namespace psmks
{
class GraphEquations;

/** A measured pose of one node of a graph, seen from another node. */
struct PoseLink
{
  std::size_t from = 0, to = 0;
  Pose2 T_from_to;
  Eigen::Matrix3d information;  //!< inverse covariance of (x, y, phi) in the axes of `from`:
                                //!< 1/m^2, 1/(m rad), 1/rad^2
};

/** The pose of `to` seen from `from`, minus what the link measured: (x, y, phi) in the axes of
 * `from`, in metres and radians. */
Eigen::Vector3d linkError(const PoseLink& link, const Pose2& from, const Pose2& to);

/** Distance at which an error of a heading counts as a displacement. Definition: about the distance
 * of two keyframes that are matched against each other. */
constexpr double kLeftOpenLever_m = 4;

/** What a pose leaves open, as one length: the root of its variances, a heading counted by what it
 * moves at the end of kLeftOpenLever_m.
 *  @param covariance of (x, y, phi): m^2, m rad, rad^2 */
double leftOpen_m(const Eigen::Matrix3d& covariance);

/** Poses that are fixed together by many measured differences between them.
 *
 *     0 ---- 1 ---- 2        0 stays where it was put, the others move to where the links between
 *      \           /         them contradict each other least
 *       5 --- 4 --3
 *
 * The cost is the sum over the links of 9/2 log(1 + s/9), where s is the squared error of a link in
 * standard deviations (Cauchy, 3 standard deviations): a link that contradicts all others has
 * little influence, so that one wrong match does not bend the map. Links that are new since the
 * last optimisation count by their full square in its first step, for the drift that a closed loop
 * takes away contradicts the new links, too. */
class PoseGraph
{
 public:
  /** Adds a node at a guess of its pose.
   *  @return its number; nodes are numbered from 0 on */
  std::size_t add(const Pose2& guess);

  /** Adds a link between two nodes of the graph. */
  void add(const PoseLink& link);

  /** Moves the nodes to a minimum of the cost, by at most 10 Gauss-Newton steps from where they
   * are. A node that no link ties to a fixed one, directly or through others, stays where it is.
   *  @param firstFree the nodes before it are fixed; node 0 is fixed in any case */
  void optimise(std::size_t firstFree = 1);

  /** A node, and how well the graph knows where it is. */
  struct KnownNode
  {
    std::size_t node = 0;
    Eigen::Matrix3d covariance;  //!< of (x, y, phi) of T_from_node, in the axes of `from`
  };

  /** How well the graph knows where other nodes are, seen from one of them: along the path of links
   * that leave least open. What other paths know besides is left out, so that the covariance is
   * rather too wide than too narrow. A link that contradicts the others counts as much less as in
   * optimise().
   *  @param mostOpen_m nodes are left out where the links of the path leave more open, the squares
   * of their leftOpen_m() added
   *  @return the node itself and those that paths lead to, what is known best first */
  std::vector<KnownNode> known(std::size_t from,
                               double mostOpen_m = std::numeric_limits<double>::infinity()) const;

  /** One pose per node, by its number. */
  const std::vector<Pose2>& poses() const { return poses_; }

  const std::vector<PoseLink>& links() const { return links_; }

  /** By how much of its information a link counts in the cost at the present poses: 1 where it
   * agrees with them, less the more it contradicts them. */
  double weight(const PoseLink& link) const;

 private:
  /** A link as seen from one of its nodes. */
  struct Step
  {
    std::size_t link, to;
    double leftOpen_m2;
  };

  /** What a link says in both directions, weighed. */
  struct Way
  {
    UncertainPose T_from_to, T_to_from;
  };

  std::vector<std::size_t> freeLinks(std::size_t firstFree) const;
  double step(const std::vector<std::size_t>& links, GraphEquations& equations, bool trustNewLinks);
  void weigh(std::size_t link);
  void setLeftOpen(std::size_t node, std::size_t link, const UncertainPose& T_here_to);
  Eigen::Matrix3d covarianceBeyond(std::size_t from, const KnownNode& before,
                                   const Step& step) const;

  std::vector<Pose2> poses_;
  std::vector<PoseLink> links_;
  std::vector<Way> ways_;                 //!< of every link
  std::vector<std::vector<Step>> steps_;  //!< of every node, two for each link
  std::size_t optimisedLinks_ = 0;        //!< the links from here on are new
};
}  // namespace psmks
