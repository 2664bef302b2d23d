/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/paper/PaperCovariance.h>
#include <psmks/paper/TranslationRegression.h>

#include <Eigen/LU>

namespace psmks
{
namespace
{
/** The derivative by (x, y, phi) of the current line's (r0, phi0) as seen from the reference: r0' =
 * r0 + x cos phi0' + y sin phi0', phi0' = phi0 + phi. */
Eigen::Matrix<double, 2, 3> lineByPose(const Line& seenFromReference, const Pose2& T_ref_cur)
{
  const Eigen::Vector2d n = seenFromReference.normal();
  Eigen::Matrix<double, 2, 3> C;
  C << n.x(), n.y(), T_ref_cur.y_m * n.x() - T_ref_cur.x_m * n.y(), 0, 0, 1;
  return C;
}
}  // namespace

void PaperCovariance::assign(const PoseObjective& objective, const Pose2& T_ref_cur)
{
  const std::vector<Line>& current = objective.projection().lines;
  const std::vector<Segment>& reference = objective.reference().segments;
  orientationStep_rad_ = objective.options().fineStep_rad;
  information_.setZero();
  slopes_.setZero();
  noise_.setZero();
  pairs_.assign(current.size() * reference.size(), {});
  for (const Association& a : objective.associations().pairs) addRay(objective, a, T_ref_cur);
  for (std::size_t k = 0; k < pairs_.size(); ++k)
    if (pairs_[k].rays > 0)
      addPair(current[k / reference.size()], reference[k % reference.size()].line, T_ref_cur,
              pairs_[k]);
}

void PaperCovariance::addRay(const PoseObjective& objective, const Association& a,
                             const Pose2& T_ref_cur)
{
  const Projection& projection = objective.projection();
  const auto r = static_cast<std::size_t>(a.referenceSegment);
  const Eigen::Vector2d point(projection.x_m[a.ray], projection.y_m[a.ray]);
  const Eigen::Vector2d& normal = objective.associations().normals[r];
  const Eigen::Vector2d tangent(-normal.y(), normal.x());
  const Eigen::Vector2d arm = point - T_ref_cur.translation();
  const Eigen::Vector2d pointByPhi(-arm.y(), arm.x());

  Eigen::Vector3d full, used;
  full << residualSlope(TranslationJacobian::Full, point.normalized(), normal),
      -normal.dot(pointByPhi) / a.incidenceCosine;
  used << residualSlope(objective.options().jacobian, point.normalized(), normal), full[2];
  // The residual changes by -(dr0 - along dphi0) / cos(incidence), where dr0 and dphi0 are the
  // differences of the current line minus those of the reference line.
  const Eigen::RowVector2d byLine(-1 / a.incidenceCosine, tangent.dot(point) / a.incidenceCosine);

  const double weight =
      objective.reliability().ofPair(a.currentSegment, a.referenceSegment).weight();
  slopes_ += weight * used * full.transpose();
  PairSum& pair =
      pairs_[static_cast<std::size_t>(a.currentSegment) * objective.reference().segments.size() +
             r];
  pair.slopesByLine += weight * used * byLine;
  ++pair.rays;
}

void PaperCovariance::addPair(const Line& current, const Line& reference, const Pose2& T_ref_cur,
                              const PairSum& pair)
{
  const Eigen::Matrix2d difference = current.covariance + reference.covariance;
  noise_ += pair.slopesByLine * difference * pair.slopesByLine.transpose();
  const Eigen::Matrix<double, 2, 3> C = lineByPose(current, T_ref_cur);
  if (difference.determinant() > 0) information_ += C.transpose() * difference.inverse() * C;
}

Eigen::Matrix3d PaperCovariance::of(
    const Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3>& known) const
{
  using Small = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3>;
  const Small slopes = known.transpose() * slopes_ * known;
  const Small noise = known.transpose() * noise_ * known;
  const Small inverse = slopes.inverse();
  const Eigen::Matrix3d ofLines =
      known * Small(inverse * noise * inverse.transpose()) * known.transpose();

  // The fine search rounds the heading to its step, so its rounding error is uniform over one step.
  // It also shifts the position that the regression finds at this heading.
  const Eigen::Index places = known.cols() - 1;
  const Small position = slopes.topLeftCorner(places, places);
  Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1> shift(places + 1);
  shift << -position.inverse() * slopes.topRightCorner(places, 1), 1;
  const Eigen::Vector3d byRounding = known * shift;
  const double rounding_rad2 = orientationStep_rad_ * orientationStep_rad_ / 12;
  return ofLines + rounding_rad2 * byRounding * byRounding.transpose();
}
}  // namespace psmks
