/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/geometry/RangeInformation.h>
#include <psmks/sim/PoseBound.h>

#include <Eigen/LU>
#include <cmath>
#include <vector>

namespace psmks
{
namespace
{
constexpr double kOutlierSigmas = 6;

/** The surfaces that rays can meet, addressed by Hit::object, in the frame of the reference scan.
 */
class ObjectsFromReference
{
 public:
  ObjectsFromReference(const World& world, const Pose2& T_world_ref)
      : walls_(world.walls()), circles_(world.circles()), T_ref_world_(T_world_ref.inverse())
  {
  }

  int count() const { return static_cast<int>(walls_.size() + circles_.size()); }

  SurfaceContact contact(int object, const Eigen::Vector2d& p_m) const
  {
    const auto index = static_cast<std::size_t>(object);
    return index < walls_.size() ? onLine(walls_[index], p_m)
                                 : onCircle(circles_[index - walls_.size()], p_m);
  }

 private:
  SurfaceContact onLine(const World::Wall& wall, const Eigen::Vector2d& p_m) const
  {
    const Eigen::Vector2d a = T_ref_world_ * wall.a, b = T_ref_world_ * wall.b;
    const Eigen::Vector2d tangent = (b - a).normalized();
    return SurfaceContact::onLine({tangent.y(), -tangent.x()}, (a + b) / 2, p_m);
  }

  SurfaceContact onCircle(const World::Circle& circle, const Eigen::Vector2d& p_m) const
  {
    return SurfaceContact::onCircle(T_ref_world_ * circle.centre_m, p_m);
  }

  const std::vector<World::Wall>& walls_;
  const std::vector<World::Circle>& circles_;
  Pose2 T_ref_world_;
};

/** The sums of RangeInformation of all objects over both scans. */
class BoundSums
{
 public:
  BoundSums(const World& world, const Pose2& T_world_ref, const RangeNoise& noise)
      : objects_(world, T_world_ref),
        noise_(noise),
        slotOfObject_(static_cast<std::size_t>(objects_.count()), kNoSlot)
  {
  }

  void addReference(const SimulatedScan& scan) { addScan(scan, Pose2{}, false); }

  void addCurrent(const SimulatedScan& scan, const Pose2& T_ref_cur)
  {
    addScan(scan, T_ref_cur, true);
  }

  PoseBound bound() const
  {
    PoseInformation total;
    for (const RangeInformation& object : sums_) object.addTo(total);
    const double information = 1 / noise_.varianceAt_m2(0);
    return {information * total.information, information * total.pull};
  }

 private:
  static constexpr int kNoSlot = -1;

  bool counts(int object, double range_m, double noise_m) const
  {
    return object >= 0 && object < objects_.count() &&
           std::abs(noise_m) <= kOutlierSigmas * noise_.sigmaAt_m(range_m);
  }

  void addScan(const SimulatedScan& scan, const Pose2& T_ref_scan, bool isCurrent)
  {
    const Eigen::Matrix2d R_ref_scan = T_ref_scan.rotation();
    for (std::size_t i = 0; i < scan.objectOfRay.size(); ++i)
    {
      const double range_m = scan.scan.range_m[i] - scan.noise_m[i];
      if (!counts(scan.objectOfRay[i], range_m, scan.noise_m[i])) continue;
      const SurfaceRay ray{T_ref_scan.translation(),
                           R_ref_scan * scan.scan.grid.direction(static_cast<int>(i)),
                           range_m,
                           scan.noise_m[i],
                           isCurrent,
                           noise_.weightAt(range_m)};
      const Eigen::Vector2d end_m = ray.origin_m + ray.range_m * ray.direction;
      sumsOf(scan.objectOfRay[i]).add(ray, objects_.contact(scan.objectOfRay[i], end_m));
    }
  }

  RangeInformation& sumsOf(int object)
  {
    int& slot = slotOfObject_[static_cast<std::size_t>(object)];
    if (slot == kNoSlot)
    {
      slot = static_cast<int>(sums_.size());
      sums_.emplace_back();
    }
    return sums_[static_cast<std::size_t>(slot)];
  }

  ObjectsFromReference objects_;
  RangeNoise noise_;
  std::vector<int> slotOfObject_;
  std::vector<RangeInformation> sums_;
};
}  // namespace

PoseBound poseBound(const World& world, const Pose2& T_world_ref, const SimulatedScan& reference,
                    const Pose2& T_world_cur, const SimulatedScan& current, const RangeNoise& noise)
{
  BoundSums sums(world, T_world_ref, noise);
  sums.addReference(reference);
  sums.addCurrent(current, T_world_ref.inverse() * T_world_cur);
  return sums.bound();
}

// The normal equations are (information + covariance^-1) error = pull + covariance^-1 prior. Both
// sides are multiplied by the covariance, which may then be singular.
Eigen::Vector3d mostLikelyError(const PoseBound& bound, const Eigen::Vector3d& priorError,
                                const Eigen::Matrix3d& priorCovariance)
{
  const Eigen::Matrix3d weights = Eigen::Matrix3d::Identity() + priorCovariance * bound.information;
  return weights.partialPivLu().solve(priorCovariance * bound.pull + priorError);
}
}  // namespace psmks
