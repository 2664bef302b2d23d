/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/base/OptionTable.h>
#include <psmks/geometry/Pose2.h>
#include <psmks/mrpt/SurfaceField.h>

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace psmks
{
/** How points are registered to the surfaces of a map. The fields have the names of those of
 *  mrpt::slam::CICP::TConfigParams that steer the same. */
struct RegistrationOptions
{
  int maxIterations = 40;      //!< Gauss-Newton steps from one start
  double thresholdDist = 0.5;  //!< gate at first, m: points so far from a surface are drawn to it
  double smallestThresholdDist = 0.03;      //!< the last gate, m
  double ALFA = 0.5;                        //!< from one gate to the next
  double minAbsStep_trans = 1e-4;           //!< m: a shorter step ends the last gate
  double minAbsStep_rot = degToRad(1e-3);   //!< rad: the same
  int corresponding_points_decimation = 1;  //!< one of so many points of the current map is used
};

/** The fields of the section [map]. */
void listFields(OptionTable& table, RegistrationOptions& options);

/** The pose at which points lie best on the surfaces of a map. */
struct Registration
{
  Pose2 T_map_points;

  /** What the points say about (x, y, phi), without the prior. Points on one surface share the
   *  errors of the map there: its information is bounded by its thickness beyond the noise. Only
   *  isolated surfaces say something along themselves, though all of them pull: what seems to be
   * the end of a wall may be that of the view. */
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();

  int covered = 0;           //!< points that the map shows a surface near
  int explained = 0;         //!< of them, those within three standard deviations and 0.1 m of it
  double logLikelihood = 0;  //!< of all points, in nat; a point away from surfaces may be anywhere
  int iterations = 0;
  bool converged = false;  //!< whether the last step was shorter than the options ask for

  /** The share of the covered points that are explained; 0 where none is covered. */
  double explainedShare() const
  {
    return covered > 0 ? static_cast<double>(explained) / covered : 0;
  }
};

/** Registers points, such as those of a scan, to a map by Gauss-Newton on the distances across its
 *  surfaces (docs/derivations.md, "Maps").
 *
 *  A gate that narrows from step to step counts as additional noise, and the windows of the field
 *  narrow with it: at first a point is drawn to what is near, in the end to what it lies on. The
 *  kernel of Geman and McClure takes weight from points that no surface explains. */
class MapRegistration
{
 public:
  /** The points and the map must outlive the registration.
   *  @param points_m in their own frame
   *  @param pointSigma_m standard deviation of a point about its surface
   *  @param map in a frame that has the axes of the map, with its origin near the pose that is
   *  looked for
   *  @param origin_m that origin in the frame of the map */
  MapRegistration(const std::vector<Eigen::Vector2d>& points_m, double pointSigma_m,
                  SurfaceField& map, const Eigen::Vector2d& origin_m,
                  const RegistrationOptions& options);

  /** A guess with a covariance, which counts as a measurement. */
  struct Prior
  {
    Pose2 T_map_points;
    Eigen::Matrix3d covariance;  //!< positive definite
  };

  /** Leads a start to a pose.
   *  @param firstGate_m how far the start may be off */
  Registration refine(const Pose2& start, const std::optional<Prior>& prior, double firstGate_m);

 private:
  struct Gate
  {
    double variance_m2;    //!< of a point, with that of the gate
    int finest, coarsest;  //!< levels of the field
  };

  /** A pose of the points in the frame of the field, for use with many points. */
  struct Motion
  {
    Eigen::Matrix2d rotation, derivative;
    Eigen::Vector2d translation;
  };

  /** The distance of a point from its surface, across and along it. */
  struct Residual
  {
    const Surface* surface = nullptr;
    Eigen::Vector2d error_m;               //!< across, along
    Eigen::Matrix<double, 2, 3> jacobian;  //!< by (x, y, phi)
    Eigen::Vector2d information;           //!< about the error: 1/m^2
    double weight = 0;                     //!< of the kernel
  };

  struct NormalSums
  {
    Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
    Eigen::Vector3d g = Eigen::Vector3d::Zero();
  };

  Motion motionOf(const Pose2& T_map_points) const;
  Gate gateOf(double gate_m) const;
  bool settle(double gate_m, const std::optional<Prior>& prior, Registration& registration);
  Residual residual(const Eigen::Vector2d& point_m, const Motion& motion, const Gate& gate);
  NormalSums linearise(const Motion& motion, const Gate& gate);
  void inform(const Motion& motion, Registration& registration);
  void judge(const Motion& motion, Registration& registration);

  const std::vector<Eigen::Vector2d>& points_m_;
  double pointVariance_m2_;
  SurfaceField& map_;
  Eigen::Vector2d origin_m_;
  RegistrationOptions options_;
};
}  // namespace psmks
