/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/geometry/RangeInformation.h>

#include <cmath>

// Derivation of the row that a ray adds to the normal equations. The ray leaves o along the unit
// vector e and meets an object at p = o + r e, where the surface of the object has the normal u:
//
//        u                 If o moves by do, the ray turns by dphi, and the surface moves by ds
//        ^                 along u, then the ray still ends on the surface:
//     ___|____ p
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
// Every ray is thus one row of a linear regression of its noise on the error of the pose and on up
// to three unknowns of its object: two of a line, three of a circle.

namespace psmks
{
namespace
{
constexpr int kObject = 3, kNoise = 6;

/** Rays that meet a surface at a smaller cosine of incidence are left out: where a ray grazes the
 * surface, its range is no longer a linear function of the pose. */
constexpr double kMinIncidenceCosine = 1e-3;

/** If elimination has reduced a pivot to less than this share of its first value, what is left of
 * it is rounding error, and the unknown counts as determined by those before it. */
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

// The Schur complement of the unknowns of the object, by elimination. The column of an unknown that
// depends on those before it is then zero but for rounding error, and is skipped.
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
