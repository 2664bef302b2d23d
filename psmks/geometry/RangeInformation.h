/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <Eigen/Core>

namespace psmks
{
/** Where a ray meets the surface of an object, a line or a circle, in the axes of the reference. */
struct SurfaceContact
{
  Eigen::Vector2d normal;  //!< unit vector
  /** Derivatives of the place of the surface along the normal with respect to the unknowns of the
   * object; those beyond `unknowns` are 0. */
  Eigen::Vector3d surfaceRow;
  int unknowns;  //!< 2 of a line, 3 of a circle

  /** On a line: its distance, and its angle about a point of it.
   *  @param normal unit vector
   *  @param anchor_m any point of the line, the same for all its rays */
  static SurfaceContact onLine(const Eigen::Vector2d& normal, const Eigen::Vector2d& anchor_m,
                               const Eigen::Vector2d& contact_m);

  /** On a circle: its radius and its centre. */
  static SurfaceContact onCircle(const Eigen::Vector2d& centre_m, const Eigen::Vector2d& contact_m);
};

/** A ray of either scan, in the axes of the reference. */
struct SurfaceRay
{
  Eigen::Vector2d origin_m, direction;
  double range_m;
  double noise_m;     //!< error of this range, measured minus true; 0 where it is not known
  bool fromCurrent;   //!< moves with the error of T_ref_cur
  double weight = 1;  //!< see RangeNoise::weightAt()
};

/** What rays of a standard deviation of 1 m say about the error (x, y, phi) of T_ref_cur, in the
 * axes of the reference. */
struct PoseInformation
{
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  /** Right side of the normal equations, information * error = pull: of the errors of the ranges
   * that SurfaceRay::noise_m states. */
  Eigen::Vector3d pull = Eigen::Vector3d::Zero();
};

/** Normal equations of all rays of two scans on one object, whose place, and angle or radius, are
 * unknown. */
class RangeInformation
{
 public:
  /** Rays that graze the surface are left out: they say nothing linear about it. */
  void add(const SurfaceRay& ray, const SurfaceContact& contact);

  /** Adds what is left for the pose once the object's own unknowns have explained all they can:
   * nothing where only one scan sees it or where there are no more rays than unknowns. */
  void addTo(PoseInformation& total) const;

 private:
  /** Columns of the regression. Unit: columns. Definition: three of the pose, three unknowns of the
   * object, one of the noise. */
  static constexpr int kColumns = 7;
  Eigen::Matrix<double, kColumns, kColumns> sums_ =
      Eigen::Matrix<double, kColumns, kColumns>::Zero();
  int referenceRays_ = 0, currentRays_ = 0, unknowns_ = 0;
};
}  // namespace psmks
