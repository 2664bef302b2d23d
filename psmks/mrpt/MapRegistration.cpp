/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/geometry/Observability.h>
#include <psmks/joint/OpenDirections.h>
#include <psmks/mrpt/MapRegistration.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace psmks
{
namespace
{
/** Distance in standard deviations at which the kernel has taken three quarters of the weight of a
 * point, and up to which a surface explains a point. Evidence: measured. */
constexpr double kKernelWidth = 3;

/** The coarsest level of the field that says where a surface is, and not only where to look for it.
 * Its windows are 0.84 m wide. Unit: level. Evidence: open. */
constexpr int kCoarsestSurface = 2;

/** Distance from a surface beyond which it does not explain a point, however thick it is. Unit: m.
 * Evidence: open. */
constexpr double kExplained_m = 0.1;

/** What a distribution says beyond the even one over its window, whose variance is a twelfth of the
 * square of the window: points that fill a window along a wall fix nothing along it. */
double informationBeyondEven(double variance_m2, double window_m)
{
  return std::max(0.0, 1 / variance_m2 - 12 / (window_m * window_m));
}

/** Variance of the direction of a line through points, in rad^2. By it what is known across the
 * line counts along it, too. */
double tiltVariance(const Surface& surface)
{
  return surface.acrossVariance_m2 / (surface.points * surface.alongVariance_m2);
}

/** The information without that along the direction known worst, where the errors of normals
 * explain all of it. */
Eigen::Matrix3d withoutTilt(const Eigen::Matrix3d& information, const Eigen::Matrix3d& ofTilt)
{
  const Eigen::Vector2d u = observability(information).weakDirection;
  const Eigen::Matrix2d beyond = (information - ofTilt).topLeftCorner<2, 2>();
  if (u.dot(beyond * u) > 0) return information;
  return withoutDirection({information, Eigen::Vector3d::Zero()}, u).H;
}

/** The information that points on one surface hold, over what they held if their errors were
 * independent. With k of them and n of the reference in a window, the distance between both has the
 * variance s^2 / k + s^2 / (n / 3) + t^2: a point of the reference lies in three windows along a
 * wall, and the thickness t of the surface beyond the noise s is an error that all k share. */
double independentShare(const Surface& surface, int points, double pointVariance_m2)
{
  constexpr double kWindowsOfAPoint = 3;
  const double thickness_m2 = surface.acrossVariance_m2;
  const double ifIndependent = (pointVariance_m2 + thickness_m2) / points;
  const double shared = pointVariance_m2 / points +
                        kWindowsOfAPoint * pointVariance_m2 / surface.points +
                        std::max(0.0, thickness_m2 - pointVariance_m2);
  return std::min(1.0, ifIndependent / shared);
}

/** Geman and McClure's kernel. */
double kernelWeight(double mahalanobis2)
{
  const double x = 1 + mahalanobis2 / (kKernelWidth * kKernelWidth);
  return 1 / (x * x);
}
}  // namespace

void listFields(OptionTable& table, RegistrationOptions& o)
{
  table.beginSection("map", "Alignment of maps, where maps are matched instead of scans.");
  table.add("max_iterations", o.maxIterations, 1, 1000, "Gauss-Newton steps from one start");
  table.add("first_gate_m", o.thresholdDist, Unit::Metre, 0.001, 5,
            "distance from which points are drawn to a surface at first");
  table.add("last_gate_m", o.smallestThresholdDist, Unit::Metre, 0.001, 1, "the same in the end");
  table.add("gate_ratio", o.ALFA, Unit::None, 0.01, 0.99, "from one gate to the next");
  table.add("stop_translation_m", o.minAbsStep_trans, Unit::Metre, 0, 0.01,
            "shorter steps end the refinement");
  table.add("stop_rotation_deg", o.minAbsStep_rot, Unit::Degree, 0, degToRad(1), "the same");
  table.add("every_point", o.corresponding_points_decimation, 1, 1000,
            "one of so many points of the current map is used");
}

MapRegistration::MapRegistration(const std::vector<Eigen::Vector2d>& points_m, double pointSigma_m,
                                 SurfaceField& map, const Eigen::Vector2d& origin_m,
                                 const RegistrationOptions& options)
    : points_m_(points_m),
      pointVariance_m2_(pointSigma_m * pointSigma_m),
      map_(map),
      origin_m_(origin_m),
      options_(options)
{
}

Registration MapRegistration::refine(const Pose2& start, const std::optional<Prior>& prior,
                                     double firstGate_m)
{
  Registration registration;
  registration.T_map_points = start;
  for (double gate_m = firstGate_m; gate_m > options_.smallestThresholdDist;
       gate_m *= options_.ALFA)
    settle(gate_m, prior, registration);
  registration.converged = settle(0, prior, registration);
  const Motion motion = motionOf(registration.T_map_points);
  inform(motion, registration);
  judge(motion, registration);
  return registration;
}

MapRegistration::Motion MapRegistration::motionOf(const Pose2& T_map_points) const
{
  return {T_map_points.rotation(), T_map_points.rotationDerivative(),
          T_map_points.translation() - origin_m_};
}

/** The windows reach as far as the gate, and in the end are those that hold a surface. */
MapRegistration::Gate MapRegistration::gateOf(double gate_m) const
{
  int finest = 0;
  while (finest < SurfaceField::kLevels - 1 && SurfaceField::cell_m(finest) * 1.5 < 2 * gate_m)
    ++finest;
  return {pointVariance_m2_ + gate_m * gate_m, finest, std::max(finest, kCoarsestSurface)};
}

/** Gauss-Newton with one gate.
 *  @return whether the steps became short */
bool MapRegistration::settle(double gate_m, const std::optional<Prior>& prior,
                             Registration& registration)
{
  /** Steps with one gate at most. Evidence: open. */
  constexpr int kMostSteps = 8;
  /** A step shorter than this share of the gate waits for the next one. Evidence: open. */
  constexpr double kShortStep = 0.02;
  /** Keeps the pose along what nothing fixes, as a prior of 1 m and 1 rad about the last step. */
  const Eigen::Vector3d damping = Eigen::Vector3d::Ones();
  const Gate gate = gateOf(gate_m);
  const double stop_m = std::max(options_.minAbsStep_trans, kShortStep * gate_m);
  const double stop_rad = std::max(options_.minAbsStep_rot, kShortStep * gate_m / 5);

  Pose2& T = registration.T_map_points;
  for (int step = 0; step < kMostSteps && registration.iterations < options_.maxIterations; ++step)
  {
    ++registration.iterations;
    NormalSums sums = linearise(motionOf(T), gate);
    if (prior)
    {
      const Pose2& guess = prior->T_map_points;
      const Eigen::Matrix3d known = prior->covariance.inverse();
      sums.H += known;
      sums.g += known * Eigen::Vector3d(guess.x_m - T.x_m, guess.y_m - T.y_m,
                                        wrapAngle(guess.phi_rad - T.phi_rad));
    }
    sums.H.diagonal() += damping;
    const Eigen::Vector3d move = sums.H.ldlt().solve(sums.g);
    T = {T.x_m + move.x(), T.y_m + move.y(), wrapAngle(T.phi_rad + move.z())};
    if (move.head<2>().norm() < stop_m && std::abs(move.z()) < stop_rad) return true;
  }
  return false;
}

MapRegistration::Residual MapRegistration::residual(const Eigen::Vector2d& point_m,
                                                    const Motion& motion, const Gate& gate)
{
  Residual r;
  const Eigen::Vector2d place = motion.rotation * point_m + motion.translation;
  r.surface = map_.finestAt(place, gate.finest, gate.coarsest);
  if (!r.surface) return r;
  const Surface& s = *r.surface;
  Eigen::Matrix2d axes;  // rows: across the surface and along it
  axes << s.normal.x(), s.normal.y(), -s.normal.y(), s.normal.x();
  r.error_m = axes * (place - s.mean_m);
  r.jacobian << axes, axes * (motion.derivative * point_m);
  r.information = {informationBeyondEven(s.acrossVariance_m2 + gate.variance_m2, s.window_m),
                   informationBeyondEven(s.alongVariance_m2 + gate.variance_m2, s.window_m)};
  r.weight = kernelWeight(r.information.dot(r.error_m.cwiseAbs2()));
  return r;
}

MapRegistration::NormalSums MapRegistration::linearise(const Motion& motion, const Gate& gate)
{
  NormalSums sums;
  for (const Eigen::Vector2d& point_m : points_m_)
  {
    const Residual r = residual(point_m, motion, gate);
    if (!r.surface) continue;
    const Eigen::Matrix<double, 3, 2> weighted =
        r.jacobian.transpose() * (r.weight * r.information).asDiagonal();
    sums.H += weighted * r.jacobian;
    sums.g -= weighted * r.error_m;
  }
  return sums;
}

/** Sums the information of the points surface by surface. Normals that are tilted by the noise make
 * a bare wall look as if it fixed the place along it; where that is all that is known, nothing is.
 */
void MapRegistration::inform(const Motion& motion, Registration& registration)
{
  /** What the errors of normals may add up to. Unit: means. Definition: 95 % of the squares of
   * errors are below four times their mean. */
  constexpr double kOfTilt = 4;
  struct OfSurface
  {
    const Surface* surface;
    int points = 0;
    Eigen::Matrix3d H = Eigen::Matrix3d::Zero(), ofTilt = Eigen::Matrix3d::Zero();
  };
  std::vector<OfSurface> surfaces;  // in the order of the points, so that sums do not depend on
  std::unordered_map<const Surface*, std::size_t> indices;  // where surfaces lie in memory
  const Gate gate = gateOf(0);
  for (const Eigen::Vector2d& point_m : points_m_)
  {
    const Residual r = residual(point_m, motion, gate);
    if (!r.surface) continue;
    const auto [place, isNew] = indices.emplace(r.surface, surfaces.size());
    if (isNew) surfaces.push_back({r.surface});
    OfSurface& of = surfaces[place->second];
    ++of.points;
    // What seems to end a wall may be the end of what was seen of it.
    const Eigen::Vector2d known(r.information[0], r.surface->isIsolated ? r.information[1] : 0);
    of.H += r.jacobian.transpose() * (r.weight * known).asDiagonal() * r.jacobian;
    const Eigen::RowVector3d along = r.jacobian.row(1);
    of.ofTilt += kOfTilt * r.weight * r.information[0] * tiltVariance(*r.surface) *
                 along.transpose() * along;
  }
  Eigen::Matrix3d ofTilt = Eigen::Matrix3d::Zero();
  for (const OfSurface& of : surfaces)
  {
    const double share = independentShare(*of.surface, of.points, pointVariance_m2_);
    registration.information += share * of.H;
    ofTilt += share * of.ofTilt;
  }
  registration.information = withoutTilt(registration.information, ofTilt);
}

/** Counts the points that lie on surfaces. A point lies on the surface that is seen at its place,
 * with its noise, or one time in ten anywhere in a strip. */
void MapRegistration::judge(const Motion& motion, Registration& registration)
{
  /** Share of points that no surface of the map explains. Unit: probability. Evidence: open. */
  constexpr double kStray = 0.1;
  /** Width of the strip in which a stray point may lie. Unit: m. Evidence: open. */
  constexpr double kStrip_m = 0.4;
  for (const Eigen::Vector2d& point_m : points_m_)
  {
    const Eigen::Vector2d place = motion.rotation * point_m + motion.translation;
    const Surface* surface = map_.finestAt(place, 0, kCoarsestSurface);
    double likelihood = kStray;
    if (surface)
    {
      const double variance_m2 = surface->acrossVariance_m2 + pointVariance_m2_;
      const double error_m = surface->normal.dot(place - surface->mean_m);
      const double chi2 = error_m * error_m / variance_m2;
      likelihood +=
          (1 - kStray) * kStrip_m * std::exp(-chi2 / 2) / std::sqrt(2 * kPi * variance_m2);
      ++registration.covered;
      if (chi2 < kKernelWidth * kKernelWidth && std::abs(error_m) < kExplained_m)
        ++registration.explained;
    }
    registration.logLikelihood += std::log(likelihood);
  }
}
}  // namespace psmks
