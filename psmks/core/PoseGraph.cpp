/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/core/PoseGraph.h>

#include <Eigen/SparseCholesky>

namespace psmks
{
namespace
{
using Triplets = std::vector<Eigen::Triplet<double>>;

constexpr int kMostSteps = 10;
constexpr double kSmallStep = 1e-5;  //!< metres and radians
constexpr double kKernelWidth = 3;   //!< standard deviations

/** Residual of a link and its derivatives: T_from^-1 T_to minus what was measured. */
struct LinkResidual
{
  LinkResidual(const PoseLink& link, const Pose2& from, const Pose2& to)
  {
    const Pose2 between = from.inverse() * to;
    error << between.x_m - link.T_from_to.x_m, between.y_m - link.T_from_to.y_m,
        wrapAngle(between.phi_rad - link.T_from_to.phi_rad);
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

/** Normal equations of all nodes but the first. */
class GraphEquations
{
 public:
  explicit GraphEquations(std::size_t nodes)
      : size_(3 * (static_cast<Eigen::Index>(nodes) - 1)), gradient_(Eigen::VectorXd::Zero(size_))
  {
    // Holds nodes without a link: a standard deviation of a kilometre.
    constexpr double kNextToNothing = 1e-6;
    for (Eigen::Index i = 0; i < size_; ++i) entries_.emplace_back(i, i, kNextToNothing);
  }

  void add(const PoseLink& link, const LinkResidual& r)
  {
    const double s = r.error.dot(link.information * r.error);
    const Eigen::Matrix3d W = link.information / (1 + s / (kKernelWidth * kKernelWidth));
    const Eigen::Matrix3d fromW = r.byFrom.transpose() * W, toW = r.byTo.transpose() * W;
    addBlock(link.from, link.from, fromW * r.byFrom);
    addBlock(link.from, link.to, fromW * r.byTo);
    addBlock(link.to, link.from, toW * r.byFrom);
    addBlock(link.to, link.to, toW * r.byTo);
    if (link.from > 0) gradient_.segment<3>(row(link.from)) -= fromW * r.error;
    if (link.to > 0) gradient_.segment<3>(row(link.to)) -= toW * r.error;
  }

  Eigen::VectorXd solve() const
  {
    Eigen::SparseMatrix<double> H(size_, size_);
    H.setFromTriplets(entries_.begin(), entries_.end());
    return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(H).solve(gradient_);
  }

  static Eigen::Index row(std::size_t node) { return 3 * (static_cast<Eigen::Index>(node) - 1); }

 private:
  void addBlock(std::size_t a, std::size_t b, const Eigen::Matrix3d& block)
  {
    if (a == 0 || b == 0) return;
    for (Eigen::Index i = 0; i < 3; ++i)
      for (Eigen::Index j = 0; j < 3; ++j)
        entries_.emplace_back(row(a) + i, row(b) + j, block(i, j));
  }

  Eigen::Index size_;
  Eigen::VectorXd gradient_;
  Triplets entries_;
};
}  // namespace

std::size_t PoseGraph::add(const Pose2& guess)
{
  poses_.push_back(guess);
  return poses_.size() - 1;
}

void PoseGraph::optimise()
{
  if (poses_.size() < 2) return;
  for (int i = 0; i < kMostSteps && step() > kSmallStep; ++i)
  {
  }
}

/** @return the largest change of a coordinate */
double PoseGraph::step()
{
  GraphEquations equations(poses_.size());
  for (const PoseLink& link : links_)
    equations.add(link, LinkResidual(link, poses_[link.from], poses_[link.to]));
  const Eigen::VectorXd change = equations.solve();
  for (std::size_t node = 1; node < poses_.size(); ++node)
  {
    const Eigen::Vector3d d = change.segment<3>(GraphEquations::row(node));
    Pose2& pose = poses_[node];
    pose = {pose.x_m + d.x(), pose.y_m + d.y(), wrapAngle(pose.phi_rad + d.z())};
  }
  return change.cwiseAbs().maxCoeff();
}
}  // namespace psmks
