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

/** The normal equations of one Gauss-Newton step for the nodes from firstFree on. */
class GraphEquations
{
 public:
  GraphEquations(std::size_t nodes, std::size_t firstFree)
      : firstFree_(firstFree),
        size_(3 * static_cast<Eigen::Index>(nodes - firstFree)),
        gradient_(Eigen::VectorXd::Zero(size_))
  {
    /** Information that holds a node without a link in its place. Unit: 1/m^2 and 1/rad^2.
     * Definition: a standard deviation of a kilometre, which moves no node that has a link. */
    constexpr double kNextToNothing = 1e-6;
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

  Eigen::VectorXd solve() const
  {
    Eigen::SparseMatrix<double> lower(size_, size_);
    lower.setFromTriplets(entries_.begin(), entries_.end());
    return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(lower).solve(gradient_);
  }

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
};

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
  const Eigen::Vector3d error = linkError(link, poses_[link.from], poses_[link.to]);
  addSteps(link, kernelWeight(link, error));
}

/** Adds the two steps that a link allows. */
void PoseGraph::addSteps(const PoseLink& link, double weight)
{
  const UncertainPose there{link.T_from_to, covarianceOf(link, weight)};
  const UncertainPose back = seenFrom(there, UncertainPose());
  steps_[link.from].push_back({link.to, there, leftOpen_m2(there.covariance)});
  steps_[link.to].push_back({link.from, back, leftOpen_m2(back.covariance)});
}

/** Weighs the links of all steps anew, by how far they contradict the poses. */
void PoseGraph::weighSteps()
{
  for (std::vector<Step>& steps : steps_) steps.clear();
  for (const PoseLink& link : links_)
    addSteps(link, kernelWeight(link, linkError(link, poses_[link.from], poses_[link.to])));
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
  bool trustNewLinks = optimisedLinks_ < links_.size();
  for (int i = 0; i < kMostSteps; ++i, trustNewLinks = false)
    if (step(firstFree, trustNewLinks) < kSmallStep) break;
  optimisedLinks_ = links_.size();
  weighSteps();
}

/** One Gauss-Newton step.
 *  @return the largest change of a coordinate */
double PoseGraph::step(std::size_t firstFree, bool trustNewLinks)
{
  GraphEquations equations(poses_.size(), firstFree);
  for (std::size_t l = 0; l < links_.size(); ++l)
  {
    const PoseLink& link = links_[l];
    if (!equations.isFree(link.from) && !equations.isFree(link.to)) continue;
    const LinkResidual residual(link, poses_[link.from], poses_[link.to]);
    const bool trusted = trustNewLinks && l >= optimisedLinks_;
    equations.add(link, residual, trusted ? 1 : kernelWeight(link, residual.error));
  }
  const Eigen::VectorXd change = equations.solve();
  for (std::size_t node = firstFree; node < poses_.size(); ++node)
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
  struct Reached
  {
    double leftOpen_m2;
    std::size_t node;
    Eigen::Matrix3d covariance;
    bool operator>(const Reached& other) const { return leftOpen_m2 > other.leftOpen_m2; }
  };
  std::vector<KnownNode> known;
  std::vector<bool> isKnown(poses_.size(), false);
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> open;
  open.push({0, from, Eigen::Matrix3d::Zero()});
  while (!open.empty())
  {
    const Reached here = open.top();
    open.pop();
    if (isKnown[here.node]) continue;
    isKnown[here.node] = true;
    known.push_back({here.node, here.covariance});
    const UncertainPose T_from_here{poses_[from].inverse() * poses_[here.node], here.covariance};
    for (const Step& step : steps_[here.node])
    {
      const double there_m2 = here.leftOpen_m2 + step.leftOpen_m2;
      if (isKnown[step.to] || there_m2 > mostOpen_m * mostOpen_m) continue;
      open.push({there_m2, step.to, composed(T_from_here, step.T_here_to).covariance});
    }
  }
  return known;
}
}  // namespace psmks
