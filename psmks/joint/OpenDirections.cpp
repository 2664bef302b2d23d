/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/geometry/Observability.h>
#include <psmks/joint/OpenDirections.h>

namespace psmks
{
NormalEquations withoutDirection(const NormalEquations& scans, const Eigen::Vector2d& direction)
{
  const Eigen::Vector3d u(direction.x(), direction.y(), 0);
  const Eigen::Vector3d Hu = scans.H * u;
  const double along = u.dot(Hu);
  if (!(along > 0)) return scans;
  return {scans.H - Hu * Hu.transpose() / along, scans.g - Hu * (u.dot(scans.g) / along)};
}

NormalEquations withoutHeading(const NormalEquations& scans)
{
  const Eigen::Vector2d perHeading = positionPerHeading(scans.H);
  NormalEquations rest = scans;
  rest.H(2, 2) = -perHeading.dot(scans.H.topRightCorner<2, 1>());
  rest.g.z() = -perHeading.dot(scans.g.head<2>());
  return rest;
}
}  // namespace psmks
