/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <Eigen/Core>

namespace psmks
{
/** The point at which a ray meets the surface of a straight or round object, in the axes of the
 * reference scan. */
struct SurfaceContact
{
  Eigen::Vector2d normal;  //!< unit vector, normal to the surface
  /** Derivative of the surface's place along the normal by each unknown. */
  Eigen::Vector3d surfaceRow;
  int unknowns;  //!< number of unknowns of the object: 2 of a line, 3 of a circle

  /** The contact with a line, whose unknowns are its distance and its angle about the anchor.
   *  @param normal unit vector
   *  @param anchor_m any point of the line, the same one for all its rays */
  static SurfaceContact onLine(const Eigen::Vector2d& normal, const Eigen::Vector2d& anchor_m,
                               const Eigen::Vector2d& contact_m);

  /** The contact with a circle, whose unknowns are its radius and its centre. */
  static SurfaceContact onCircle(const Eigen::Vector2d& centre_m, const Eigen::Vector2d& contact_m);
};

/** A ray of either scan, in the axes of the reference scan. */
struct SurfaceRay
{
  Eigen::Vector2d origin_m, direction;
  double range_m;
  double noise_m;  //!< measured minus true range; 0 if it is not known
  /** True for a ray of the current scan, which moves with the error of T_ref_cur. */
  bool fromCurrent;
  double weight = 1;  //!< see RangeNoise::weightAt()
};

/** Normal equations of the error (x, y, phi) of T_ref_cur, in the axes of the reference scan, from
 * ranges with a standard deviation of 1 m. The equations are information * error = pull. */
struct PoseInformation
{
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d pull = Eigen::Vector3d::Zero();  //!< zero if the noise of the rays is not known
};

/** The information that all rays of two scans on one object hold about the pose between the scans,
 * where the place of the object is unknown as well. */
class RangeInformation
{
 public:
  /** Adds a ray. Rays that graze the surface are left out, for their ranges are not linear in the
   * pose. */
  void add(const SurfaceRay& ray, const SurfaceContact& contact);

  /** Eliminates the unknowns of the object and adds the information that remains about the pose.
   * Nothing remains if only one scan sees the object, or if there are no more rays than unknowns.
   */
  void addTo(PoseInformation& total) const;

 private:
  static constexpr int kColumns = 7;  // 3 of the pose, 3 of the object, 1 of the noise
  Eigen::Matrix<double, kColumns, kColumns> sums_ =
      Eigen::Matrix<double, kColumns, kColumns>::Zero();
  int referenceRays_ = 0, currentRays_ = 0, unknowns_ = 0;
};
}  // namespace psmks
