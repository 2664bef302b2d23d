/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/paper/TranslationRegression.h>

#include <Eigen/Eigenvalues>

namespace psmks
{
namespace
{
/** A direction with less than this share of the other's information is not fixed. Unit: share.
 * Evidence: the normals of the two walls of a corridor, estimated a degree apart, pretend to a
 * share of 1e-4. */
constexpr double kWeakShare = 3e-4;
}  // namespace

Eigen::Vector2d residualSlope(TranslationJacobian jacobian, const Eigen::Vector2d& direction,
                              const Eigen::Vector2d& refNormal)
{
  if (jacobian == TranslationJacobian::FrozenBearing) return -direction;
  return -refNormal / refNormal.dot(direction);
}

void buildTranslationProblem(const Projection& projection, const Associations& associations,
                             const SegmentReliability& reliability, TranslationJacobian jacobian,
                             TranslationProblem& problem)
{
  problem.terms.clear();
  for (const Association& a : associations.pairs)
  {
    const double range_m = projection.range_m[a.ray];
    const Eigen::Vector2d direction(projection.x_m[a.ray] / range_m,
                                    projection.y_m[a.ray] / range_m);
    const Eigen::Vector2d& normal =
        associations.normals[static_cast<std::size_t>(a.referenceSegment)];
    problem.terms.push_back({a.residual_m, residualSlope(jacobian, direction, normal),
                             reliability.ofPair(a.currentSegment, a.referenceSegment).weight()});
  }
}

Eigen::Vector2d solveTranslation(const TranslationProblem& problem)
{
  Eigen::Matrix2d A = Eigen::Matrix2d::Zero();
  Eigen::Vector2d g = Eigen::Vector2d::Zero();
  for (const TranslationTerm& term : problem.terms)
  {
    A += term.weight * term.slope * term.slope.transpose();
    g -= term.weight * term.residual_m * term.slope;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(A);
  Eigen::Vector2d step = Eigen::Vector2d::Zero();
  for (int k = 0; k < 2; ++k)
  {
    const double information = eigen.eigenvalues()[k];
    if (!(information > kWeakShare * eigen.eigenvalues()[1])) continue;
    const Eigen::Vector2d along = eigen.eigenvectors().col(k);
    step += along * (along.dot(g) / information);
  }
  return step;
}
}  // namespace psmks
