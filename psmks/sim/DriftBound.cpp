/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/geometry/Angle.h>
#include <psmks/sim/DriftBound.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
// Covariance that is added to that of the wheels, so that the prior of a robot at rest is
// invertible.
const Eigen::Matrix3d kRest = Eigen::Vector3d(1e-10, 1e-10, 1e-10).asDiagonal();

/** The error of (x, y, phi): estimate minus truth, in the axes of the reference. */
Eigen::Vector3d difference(const Pose2& estimate, const Pose2& truth)
{
  return {estimate.x_m - truth.x_m, estimate.y_m - truth.y_m,
          wrapAngle(estimate.phi_rad - truth.phi_rad)};
}

Pose2 displaced(const Pose2& truth, const Eigen::Vector3d& error)
{
  return {truth.x_m + error.x(), truth.y_m + error.y(), wrapAngle(truth.phi_rad + error.z())};
}

/** The pose graph of the keyframes, addressed by the indices of their scans. */
class KeyframeGraph
{
 public:
  explicit KeyframeGraph(std::size_t scans) : nodeOf_(scans) {}

  /** The present pose of a keyframe; nothing for a scan that is not a keyframe. */
  std::optional<Pose2> find(std::size_t scan) const
  {
    if (!nodeOf_[scan]) return std::nullopt;
    return graph_.poses()[*nodeOf_[scan]];
  }

  /** Adds a keyframe at a guess of its pose.
   *  @param links to the new keyframe; those from scans that are not keyframes are left out */
  void add(std::size_t scan, const Pose2& guess, const std::vector<PoseLink>& links)
  {
    nodeOf_[scan] = graph_.add(guess);
    for (const PoseLink& link : links)
      if (nodeOf_[link.from])
        graph_.add({*nodeOf_[link.from], *nodeOf_[scan], link.T_from_to, link.information});
  }

  void optimise() { graph_.optimise(); }

 private:
  PoseGraph graph_;
  std::vector<std::optional<std::size_t>> nodeOf_;
};
}  // namespace

DriftBound::DriftBound(const World& world, const Recording& recording,
                       const SimulationOptions& simulation)
    : world_(world),
      recording_(recording),
      robot_(simulation.robot),
      noise_(simulation.laser.rangeNoise()),
      scanPeriod_s_(simulation.scanPeriod_s)
{
}

std::vector<Pose2> DriftBound::poses(const std::vector<DriftBoundStep>& steps) const
{
  // Without links between keyframes, each pose follows from that of its reference alone.
  const bool withMap = std::any_of(steps.begin(), steps.end(),
                                   [](const DriftBoundStep& step) { return !step.links.empty(); });
  std::vector<Pose2> online;  // pose of each scan when it was added
  KeyframeGraph map(steps.size());
  for (std::size_t scan = 0; scan < steps.size(); ++scan)
  {
    const DriftBoundStep& step = steps[scan];
    const auto poseOf = [&](std::size_t s) { return map.find(s).value_or(online[s]); };
    std::vector<PoseLink> links;
    if (scan == 0)
      online.push_back(recording_.scans.front().T_world_robot);
    else if (!step.reference)
      online.push_back(online[scan - 1] * measuredMotion(scan - 1, scan));
    else
    {
      links.push_back(matched(*step.reference, scan));
      online.push_back(poseOf(*step.reference) * links.front().T_from_to);
    }
    if (!withMap || !step.joinsMap) continue;
    for (const std::size_t other : step.links) links.push_back(linked(other, scan));
    map.add(scan, online[scan], links);
    map.optimise();
  }
  return online;
}

std::vector<Pose2> DriftBound::settledPoses(const std::vector<DriftBoundStep>& steps) const
{
  std::vector<Pose2> poses{recording_.scans.front().T_world_robot};
  std::vector<PoseLink> placing(steps.size());  // of each scan, from its reference or the last scan
  KeyframeGraph map(steps.size());
  map.add(0, poses.front(), {});
  for (std::size_t scan = 1; scan < steps.size(); ++scan)
  {
    const DriftBoundStep& step = steps[scan];
    placing[scan] = step.reference ? matched(*step.reference, scan)
                                   : PoseLink{scan - 1, scan, measuredMotion(scan - 1, scan), {}};
    poses.push_back(poses[placing[scan].from] * placing[scan].T_from_to);
    if (!step.joinsMap) continue;
    std::vector<PoseLink> links{placing[scan]};
    for (const std::size_t other : step.links) links.push_back(linked(other, scan));
    map.add(scan, poses[scan], links);
  }
  map.optimise();
  for (std::size_t scan = 1; scan < steps.size(); ++scan)
    poses[scan] = map.find(scan).value_or(poses[placing[scan].from] * placing[scan].T_from_to);
  return poses;
}

PoseLink DriftBound::matched(std::size_t reference, std::size_t current) const
{
  /** Beside a match, what the wheels say of so many scans or more is nothing. Unit: scans.
   * Definition: a minute of ten scans a second, in which wheels err by decimetres. */
  constexpr std::size_t kLongAgo = 600;
  if (current - reference > kLongAgo) return linked(reference, current);
  const RecordedScan& ref = recording_.scans[reference];
  const RecordedScan& cur = recording_.scans[current];
  const Pose2 truth = ref.T_world_robot.inverse() * cur.T_world_robot;
  const PoseBound bound =
      poseBound(world_, ref.T_world_robot, ref.simulated, cur.T_world_robot, cur.simulated, noise_);
  const Eigen::Matrix3d covariance = wheelCovariance(reference, current);
  const Eigen::Vector3d error =
      mostLikelyError(bound, difference(measuredMotion(reference, current), truth), covariance);
  return {reference, current, displaced(truth, error), bound.information + covariance.inverse()};
}

PoseLink DriftBound::linked(std::size_t reference, std::size_t current) const
{
  const RecordedScan& ref = recording_.scans[reference];
  const RecordedScan& cur = recording_.scans[current];
  const PoseBound bound =
      poseBound(world_, ref.T_world_robot, ref.simulated, cur.T_world_robot, cur.simulated, noise_);
  // A prior of 1 m and 1 rad keeps directions that the scans do not constrain finite; their
  // information in the link is zero.
  const Eigen::Vector3d error =
      mostLikelyError(bound, Eigen::Vector3d::Zero(), Eigen::Matrix3d::Identity());
  return {reference, current, displaced(ref.T_world_robot.inverse() * cur.T_world_robot, error),
          bound.information};
}

Pose2 DriftBound::measuredMotion(std::size_t reference, std::size_t current) const
{
  return recording_.scans[reference].T_start_odometry.inverse() *
         recording_.scans[current].T_start_odometry;
}

/** Each wheel has its own factor of uniform noise, drawn anew for each noise step. A distance w
 * driven in n steps then has the variance w^2 / n * noise^2 / 3. An error of one wheel moves the
 * robot along its heading by half of the error and turns it by error / track, and each turn
 * displaces everything that is driven after it. */
Eigen::Matrix3d DriftBound::wheelCovariance(std::size_t reference, std::size_t current) const
{
  const double steps = scanPeriod_s_ / robot_.noiseStep_s;
  const double variancePerSquare = robot_.wheelNoise * robot_.wheelNoise / 3 / steps;
  Eigen::Matrix3d covariance = kRest;
  Pose2 T_ref_here;
  for (std::size_t scan = reference + 1; scan <= current; ++scan)
  {
    const Pose2 step = measuredMotion(scan - 1, scan);
    const double way_m = std::copysign(step.translation().norm(), step.x_m);
    const double half_m = step.phi_rad * robot_.track_m / 2;
    const double left_m2 = (way_m - half_m) * (way_m - half_m) * variancePerSquare;
    const double right_m2 = (way_m + half_m) * (way_m + half_m) * variancePerSquare;

    const double heading_rad = T_ref_here.phi_rad + step.phi_rad / 2;
    const Eigen::Vector2d ahead(std::cos(heading_rad), std::sin(heading_rad));
    const Pose2 T_ref_next = T_ref_here * step;
    const Eigen::Vector2d moved_m = T_ref_next.translation() - T_ref_here.translation();

    Eigen::Matrix3d turned = Eigen::Matrix3d::Identity();
    turned(0, 2) = -moved_m.y();
    turned(1, 2) = moved_m.x();
    Eigen::Matrix<double, 3, 2> byWheel;
    byWheel << ahead.x() / 2, ahead.x() / 2, ahead.y() / 2, ahead.y() / 2, -1 / robot_.track_m,
        1 / robot_.track_m;
    covariance = turned * covariance * turned.transpose() +
                 byWheel * Eigen::Vector2d(left_m2, right_m2).asDiagonal() * byWheel.transpose();
    T_ref_here = T_ref_next;
  }
  return covariance;
}
}  // namespace psmks
