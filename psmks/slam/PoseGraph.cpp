/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/slam/PoseGraph.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>

namespace psmks
{
namespace
{
using Triplets = std::vector<Eigen::Triplet<double>>;

/** The residual of a link and its derivatives by (x, y, phi) of its two nodes. */
struct LinkResidual
{
  LinkResidual(const PoseLink& link, const Pose2& from, const Pose2& to)
  {
    error = linkError(link, from, to);
    const Pose2 between = from.inverse() * to;
    const Eigen::Matrix2d R = from.rotation().transpose();
    byTo.setIdentity();
    byTo.topLeftCorner<2, 2>() = R;
    byFrom = -byTo;
    byFrom(0, 2) = between.y_m;
    byFrom(1, 2) = -between.x_m;
  }

  Eigen::Vector3d error;
  Eigen::Matrix3d byFrom, byTo;
};

}  // namespace

/** The normal equations of Gauss-Newton steps for the nodes from firstFree on. */
class GraphEquations
{
 public:
  GraphEquations(std::size_t nodes, std::size_t firstFree)
      : firstFree_(firstFree),
        size_(3 * static_cast<Eigen::Index>(nodes - firstFree)),
        gradient_(size_),
        lower_(size_, size_)
  {
  }

  /** Forgets the links that were added, for the next step. */
  void clear()
  {
    /** Information that holds a node without a link in its place. Unit: 1/m^2 and 1/rad^2.
     * Definition: a standard deviation of a kilometre, which moves no node that has a link. */
    constexpr double kNextToNothing = 1e-6;
    gradient_.setZero();
    entries_.clear();
    for (Eigen::Index i = 0; i < size_; ++i) entries_.emplace_back(i, i, kNextToNothing);
  }

  void add(const PoseLink& link, const LinkResidual& r, double weight)
  {
    const Eigen::Matrix3d W = weight * link.information;
    const Eigen::Matrix3d fromW = r.byFrom.transpose() * W, toW = r.byTo.transpose() * W;
    addBlock(link.from, link.from, fromW * r.byFrom);
    addBlock(link.to, link.to, toW * r.byTo);
    if (link.from > link.to)
      addBlock(link.from, link.to, fromW * r.byTo);
    else
      addBlock(link.to, link.from, toW * r.byFrom);
    if (isFree(link.from)) gradient_.segment<3>(row(link.from)) -= fromW * r.error;
    if (isFree(link.to)) gradient_.segment<3>(row(link.to)) -= toW * r.error;
  }

  /** The same nodes are linked in every step, so that their order of elimination is sought once. */
  Eigen::VectorXd solve()
  {
    lower_.setFromTriplets(entries_.begin(), entries_.end());
    if (!isOrdered_) solver_.analyzePattern(lower_);
    isOrdered_ = true;
    solver_.factorize(lower_);
    return solver_.solve(gradient_);
  }

  std::size_t firstFree() const { return firstFree_; }

  bool isFree(std::size_t node) const { return node >= firstFree_; }

  Eigen::Index row(std::size_t node) const
  {
    return 3 * static_cast<Eigen::Index>(node - firstFree_);
  }

 private:
  /** Of the symmetric matrix only the blocks on and below the diagonal are kept. */
  void addBlock(std::size_t a, std::size_t b, const Eigen::Matrix3d& block)
  {
    if (!isFree(a) || !isFree(b)) return;
    for (Eigen::Index i = 0; i < 3; ++i)
      for (Eigen::Index j = 0; j < (a == b ? i + 1 : 3); ++j)
        entries_.emplace_back(row(a) + i, row(b) + j, block(i, j));
  }

  std::size_t firstFree_;
  Eigen::Index size_;
  Eigen::VectorXd gradient_;
  Triplets entries_;
  Eigen::SparseMatrix<double> lower_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
  bool isOrdered_ = false;
};

namespace
{
/** The weight of a link in a Gauss-Newton step that makes the sum of squares a sum of Cauchy costs.
 */
double kernelWeight(const PoseLink& link, const Eigen::Vector3d& error)
{
  /** Width of the Cauchy kernel on the error of a link. Unit: standard deviations. Evidence:
   * measured.
   */
  constexpr double kKernelWidth = 3;
  return 1 / (1 + error.dot(link.information * error) / (kKernelWidth * kKernelWidth));
}

/** leftOpen_m() squared. */
double leftOpen_m2(const Eigen::Matrix3d& covariance)
{
  return covariance(0, 0) + covariance(1, 1) +
         kLeftOpenLever_m * kLeftOpenLever_m * covariance(2, 2);
}

/** The covariance of a link, which is very wide in directions that it leaves open. */
Eigen::Matrix3d covarianceOf(const PoseLink& link, double weight)
{
  /** Variance in directions that a link says nothing about. Unit: m^2 and rad^2. Definition: above
   * that of any way that is looked at. */
  constexpr double kOpen = 1e4;
  return fusedCovariance(kOpen * Eigen::Matrix3d::Identity(), weight * link.information);
}
}  // namespace

Eigen::Vector3d linkError(const PoseLink& link, const Pose2& from, const Pose2& to)
{
  const Pose2 between = from.inverse() * to;
  return {between.x_m - link.T_from_to.x_m, between.y_m - link.T_from_to.y_m,
          wrapAngle(between.phi_rad - link.T_from_to.phi_rad)};
}

double leftOpen_m(const Eigen::Matrix3d& covariance) { return std::sqrt(leftOpen_m2(covariance)); }

std::size_t PoseGraph::add(const Pose2& guess)
{
  poses_.push_back(guess);
  steps_.emplace_back();
  return poses_.size() - 1;
}

void PoseGraph::add(const PoseLink& link)
{
  links_.push_back(link);
  const std::size_t added = links_.size() - 1;
  ways_.emplace_back();
  steps_[link.from].push_back({added, link.to, 0});
  steps_[link.to].push_back({added, link.from, 0});
  weigh(added);
}

double PoseGraph::weight(const PoseLink& link) const
{
  return kernelWeight(link, linkError(link, poses_[link.from], poses_[link.to]));
}

/** Weighs what a link says in both directions by how far it contradicts the poses. */
void PoseGraph::weigh(std::size_t link)
{
  const PoseLink& weighed = links_[link];
  Way& way = ways_[link];
  way.T_from_to = {weighed.T_from_to, covarianceOf(weighed, weight(weighed))};
  way.T_to_from = seenFrom(way.T_from_to, UncertainPose());
  setLeftOpen(weighed.from, link, way.T_from_to);
  setLeftOpen(weighed.to, link, way.T_to_from);
}

void PoseGraph::setLeftOpen(std::size_t node, std::size_t link, const UncertainPose& T_here_to)
{
  const auto isOfLink = [link](const Step& step) { return step.link == link; };
  std::find_if(steps_[node].rbegin(), steps_[node].rend(), isOfLink)->leftOpen_m2 =
      leftOpen_m2(T_here_to.covariance);
}

/** The links that tie a node that is free, in their order. */
std::vector<std::size_t> PoseGraph::freeLinks(std::size_t firstFree) const
{
  std::vector<std::size_t> links;
  for (std::size_t node = firstFree; node < steps_.size(); ++node)
    for (const Step& step : steps_[node])
      if (step.to < firstFree || step.to > node) links.push_back(step.link);
  std::sort(links.begin(), links.end());
  return links;
}

void PoseGraph::optimise(std::size_t firstFree)
{
  /** Most Gauss-Newton steps of an optimisation. Unit: steps. Evidence: measured. */
  constexpr int kMostSteps = 10;

  /** An optimisation has settled once no coordinate changes by more. Unit: m and rad. Definition: a
   * hundredth of a millimetre, far below the errors of a match. */
  constexpr double kSmallStep = 1e-5;
  firstFree = std::max<std::size_t>(firstFree, 1);
  if (poses_.size() <= firstFree) return;
  const std::vector<std::size_t> links = freeLinks(firstFree);
  GraphEquations equations(poses_.size(), firstFree);
  bool trustNewLinks = optimisedLinks_ < links_.size();
  for (int i = 0; i < kMostSteps; ++i, trustNewLinks = false)
    if (step(links, equations, trustNewLinks) < kSmallStep) break;
  optimisedLinks_ = links_.size();
  for (const std::size_t link : links) weigh(link);
}

/** One Gauss-Newton step.
 *  @return the largest change of a coordinate */
double PoseGraph::step(const std::vector<std::size_t>& links, GraphEquations& equations,
                       bool trustNewLinks)
{
  equations.clear();
  for (const std::size_t l : links)
  {
    const PoseLink& link = links_[l];
    const LinkResidual residual(link, poses_[link.from], poses_[link.to]);
    const bool trusted = trustNewLinks && l >= optimisedLinks_;
    equations.add(link, residual, trusted ? 1 : kernelWeight(link, residual.error));
  }
  const Eigen::VectorXd change = equations.solve();
  for (std::size_t node = equations.firstFree(); node < poses_.size(); ++node)
  {
    const Eigen::Vector3d d = change.segment<3>(equations.row(node));
    Pose2& pose = poses_[node];
    pose = {pose.x_m + d.x(), pose.y_m + d.y(), wrapAngle(pose.phi_rad + d.z())};
  }
  return change.cwiseAbs().maxCoeff();
}

/** Dijkstra's algorithm, with what the links leave open for the lengths. */
std::vector<PoseGraph::KnownNode> PoseGraph::known(std::size_t from, double mostOpen_m) const
{
  /** A way to a node, whose last step leads there from a node that is known. */
  struct Reached
  {
    double leftOpen_m2;
    std::size_t node;
    std::size_t before;  //!< in the result
    const Step* step;
    bool operator>(const Reached& other) const { return leftOpen_m2 > other.leftOpen_m2; }
  };
  std::vector<KnownNode> known;
  std::vector<bool> isKnown(poses_.size(), false);
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> open;
  open.push({0, from, 0, nullptr});
  while (!open.empty())
  {
    const Reached here = open.top();
    open.pop();
    if (isKnown[here.node]) continue;
    isKnown[here.node] = true;
    known.push_back({here.node, here.step ? covarianceBeyond(from, known[here.before], *here.step)
                                          : Eigen::Matrix3d(Eigen::Matrix3d::Zero())});
    for (const Step& step : steps_[here.node])
    {
      const double there_m2 = here.leftOpen_m2 + step.leftOpen_m2;
      if (!isKnown[step.to] && there_m2 <= mostOpen_m * mostOpen_m)
        open.push({there_m2, step.to, known.size() - 1, &step});
    }
  }
  return known;
}

/** The covariance of the node that a step leads to, seen from a node. */
Eigen::Matrix3d PoseGraph::covarianceBeyond(std::size_t from, const KnownNode& before,
                                            const Step& step) const
{
  const Pose2 T_from_before = poses_[from].inverse() * poses_[before.node];
  const bool isForward = links_[step.link].from == before.node;
  const Way& way = ways_[step.link];
  return composed({T_from_before, before.covariance}, isForward ? way.T_from_to : way.T_to_from)
      .covariance;
}
}  // namespace psmks
