/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/geometry/RangeInformation.h>

#include <cmath>

// A ray leaves o along the unit vector e and meets an object at p = o + r e, where the object's
// surface has the normal u:
//
//        u                 If o moves by do, the ray turns by dphi and the surface moves by ds
//        along
//     ___^____ p           u, the ray still ends on the surface:
//         \ |
//          \|              u.(do + dr e + r e' dphi) = ds,   e' = e turned by 90 degrees
//           o
//                  =>      dr = (ds - u.do - r (u.e') dphi) / (u.e)
//
// The reference scan stands still (do = dphi = 0); for the current one (do, dphi) is the error of
// T_ref_cur, all vectors in the axes of the reference. The surface moves by
//
//     ds = dd + dalpha t.(p - a)    a line that shifts by dd and turns by dalpha about its point a;
//                                   t = u turned by 90 degrees
//     ds = dR + u.dc                a circle of radius R about c, u = (p - c) / R
//
// Every ray is thus one row of a linear regression of its noise on the pose and three unknowns (of
// which a line leaves one idle) of its object alone.

namespace psmks
{
namespace
{
/** First column of the object's unknowns, and the column of the noise. Unit: columns. Definition:
 * the order of the columns of RangeInformation. */
constexpr int kObject = 3, kNoise = 6;

/** Smallest cosine of incidence of a ray; one that grazes its object says nothing linear about it.
 * Unit: cosine. Definition: at 0.001 a range is known a thousand times worse than the distance that
 * it measures, so that such rays have no weight in any case. */
constexpr double kMinIncidenceCosine = 1e-3;

/** A pivot that elimination has reduced to this share of itself is 0. Unit: share. Definition: the
 * rounding of doubles in sums over a thousand rays. */
constexpr double kRankTolerance = 1e-11;

Eigen::Vector2d turned90(const Eigen::Vector2d& v) { return {-v.y(), v.x()}; }
}  // namespace

SurfaceContact SurfaceContact::onLine(const Eigen::Vector2d& normal,
                                      const Eigen::Vector2d& anchor_m,
                                      const Eigen::Vector2d& contact_m)
{
  return {normal, {1, turned90(normal).dot(contact_m - anchor_m), 0}, 2};
}

SurfaceContact SurfaceContact::onCircle(const Eigen::Vector2d& centre_m,
                                        const Eigen::Vector2d& contact_m)
{
  const Eigen::Vector2d normal = (contact_m - centre_m).normalized();
  return {normal, {1, normal.x(), normal.y()}, 3};
}

void RangeInformation::add(const SurfaceRay& ray, const SurfaceContact& contact)
{
  const Eigen::Vector2d& u = contact.normal;
  const double incidenceCosine = u.dot(ray.direction);
  if (std::abs(incidenceCosine) < kMinIncidenceCosine) return;

  Eigen::Matrix<double, kColumns, 1> row = Eigen::Matrix<double, kColumns, 1>::Zero();
  if (ray.fromCurrent) row.head<3>() << -u, -ray.range_m * u.dot(turned90(ray.direction));
  row.segment<3>(kObject) = contact.surfaceRow;
  row /= incidenceCosine;
  row(kNoise) = ray.noise_m;

  sums_.noalias() += ray.weight * row * row.transpose();
  unknowns_ = contact.unknowns;
  ++(ray.fromCurrent ? currentRays_ : referenceRays_);
}

// Schur complement of the object's unknowns. The column of an unknown that depends on those before
// it is zero by then, but for rounding.
void RangeInformation::addTo(PoseInformation& total) const
{
  if (referenceRays_ == 0 || currentRays_ == 0 || referenceRays_ + currentRays_ <= unknowns_)
    return;
  auto rest = sums_;
  for (int k = kObject; k < kNoise; ++k)
  {
    if (rest(k, k) <= kRankTolerance * sums_(k, k)) continue;
    const Eigen::Matrix<double, kColumns, 1> column = rest.col(k);
    rest.noalias() -= column / column(k) * column.transpose();
  }
  total.information += rest.topLeftCorner<3, 3>();
  total.pull += rest.col(kNoise).head<3>();
}
}  // namespace psmks
