/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/sim/PoseBound.h>

#include <Eigen/LU>
#include <cmath>
#include <vector>

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
constexpr int kObject = 3, kNoise = 6, kColumns = 7;
using Row = Eigen::Matrix<double, kColumns, 1>;
using Sums = Eigen::Matrix<double, kColumns, kColumns>;

constexpr double kOutlierSigmas = 6;

/** A ray that grazes its object says nothing linear about it. */
constexpr double kMinIncidenceCosine = 1e-3;

/** A pivot that elimination has reduced to this share of itself is rounding. */
constexpr double kRankTolerance = 1e-11;

Eigen::Vector2d turned90(const Eigen::Vector2d& v) { return {-v.y(), v.x()}; }

/** Where a ray meets the surface of its object, in the axes of the reference. */
struct Contact
{
  Eigen::Vector2d normal;
  Eigen::Vector3d surfaceRow;  //!< derivative of ds by the unknowns of the object
  int unknowns;
};

/** What can be met, by Hit::object, moved into the frame of the reference. */
class ObjectsFromReference
{
 public:
  ObjectsFromReference(const World& world, const Pose2& T_world_ref)
      : walls_(world.walls()), circles_(world.circles()), T_ref_world_(T_world_ref.inverse())
  {
  }

  int count() const { return static_cast<int>(walls_.size() + circles_.size()); }

  Contact contact(int object, const Eigen::Vector2d& p_m) const
  {
    const auto index = static_cast<std::size_t>(object);
    return index < walls_.size() ? onLine(walls_[index], p_m)
                                 : onCircle(circles_[index - walls_.size()], p_m);
  }

 private:
  Contact onLine(const World::Wall& wall, const Eigen::Vector2d& p_m) const
  {
    const Eigen::Vector2d a = T_ref_world_ * wall.a, b = T_ref_world_ * wall.b;
    const Eigen::Vector2d tangent = (b - a).normalized();
    return {-turned90(tangent), {1, tangent.dot(p_m - (a + b) / 2), 0}, 2};
  }

  Contact onCircle(const World::Circle& circle, const Eigen::Vector2d& p_m) const
  {
    const Eigen::Vector2d normal = (p_m - T_ref_world_ * circle.centre_m).normalized();
    return {normal, {1, normal.x(), normal.y()}, 3};
  }

  const std::vector<World::Wall>& walls_;
  const std::vector<World::Circle>& circles_;
  Pose2 T_ref_world_;
};

/** The normal equations of the rays on one object: pose, object, noise. */
struct ObjectSums
{
  Sums sums = Sums::Zero();
  int referenceRays = 0, currentRays = 0, unknowns = 0;

  bool tellsPose() const
  {
    return referenceRays > 0 && currentRays > 0 && referenceRays + currentRays > unknowns;
  }

  /** Schur complement of the object's unknowns. The column of an unknown that depends on those
   * before it is zero by then, but for rounding. */
  void eliminateObject()
  {
    const Row before = sums.diagonal();
    for (int k = kObject; k < kNoise; ++k)
    {
      if (sums(k, k) <= kRankTolerance * before(k)) continue;
      const Row column = sums.col(k);
      sums.noalias() -= column / column(k) * column.transpose();
    }
  }
};

/** Sums of all objects over both scans. */
class BoundSums
{
 public:
  BoundSums(const World& world, const Pose2& T_world_ref, double rangeSigma_m)
      : objects_(world, T_world_ref),
        rangeSigma_m_(rangeSigma_m),
        slotOfObject_(static_cast<std::size_t>(objects_.count()), kNoSlot)
  {
  }

  void addReference(const SimulatedScan& scan) { addScan(scan, Pose2{}, false); }

  void addCurrent(const SimulatedScan& scan, const Pose2& T_ref_cur)
  {
    addScan(scan, T_ref_cur, true);
  }

  PoseBound bound()
  {
    Sums total = Sums::Zero();
    for (ObjectSums& object : sums_)
    {
      if (!object.tellsPose()) continue;
      object.eliminateObject();
      total += object.sums;
    }
    const double information = 1 / (rangeSigma_m_ * rangeSigma_m_);
    return {information * total.topLeftCorner<3, 3>(), information * total.col(kNoise).head<3>()};
  }

 private:
  static constexpr int kNoSlot = -1;

  /** A true ray in the axes of the reference. */
  struct Ray
  {
    int object;
    Eigen::Vector2d origin_m, e;
    double range_m, noise_m;
    bool moves;  //!< with the error of T_ref_cur
  };

  bool counts(int object, double noise_m) const
  {
    return object >= 0 && object < objects_.count() &&
           std::abs(noise_m) <= kOutlierSigmas * rangeSigma_m_;
  }

  void addScan(const SimulatedScan& scan, const Pose2& T_ref_scan, bool moves)
  {
    const Eigen::Matrix2d R_ref_scan = T_ref_scan.rotation();
    for (std::size_t i = 0; i < scan.objectOfRay.size(); ++i)
      if (counts(scan.objectOfRay[i], scan.noise_m[i]))
        addRay({scan.objectOfRay[i], T_ref_scan.translation(),
                R_ref_scan * scan.scan.grid.direction(static_cast<int>(i)),
                scan.scan.range_m[i] - scan.noise_m[i], scan.noise_m[i], moves});
  }

  void addRay(const Ray& ray)
  {
    const Contact contact = objects_.contact(ray.object, ray.origin_m + ray.range_m * ray.e);
    const Eigen::Vector2d& u = contact.normal;
    const double incidenceCosine = u.dot(ray.e);
    if (std::abs(incidenceCosine) < kMinIncidenceCosine) return;

    Row row = Row::Zero();
    if (ray.moves) row.head<3>() << -u, -ray.range_m * u.dot(turned90(ray.e));
    row.segment<3>(kObject) = contact.surfaceRow;
    row /= incidenceCosine;
    row(kNoise) = ray.noise_m;

    ObjectSums& object = sumsOf(ray.object);
    object.sums.noalias() += row * row.transpose();
    object.unknowns = contact.unknowns;
    ++(ray.moves ? object.currentRays : object.referenceRays);
  }

  ObjectSums& sumsOf(int object)
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
  double rangeSigma_m_;
  std::vector<int> slotOfObject_;
  std::vector<ObjectSums> sums_;
};
}  // namespace

PoseBound poseBound(const World& world, const Pose2& T_world_ref, const SimulatedScan& reference,
                    const Pose2& T_world_cur, const SimulatedScan& current, double rangeSigma_m)
{
  BoundSums sums(world, T_world_ref, rangeSigma_m);
  sums.addReference(reference);
  sums.addCurrent(current, T_world_ref.inverse() * T_world_cur);
  return sums.bound();
}

// (information + covariance^-1) error = pull + covariance^-1 prior, multiplied by the covariance,
// which may then be singular.
Eigen::Vector3d mostLikelyError(const PoseBound& bound, const Eigen::Vector3d& priorError,
                                const Eigen::Matrix3d& priorCovariance)
{
  const Eigen::Matrix3d weights = Eigen::Matrix3d::Identity() + priorCovariance * bound.information;
  return weights.partialPivLu().solve(priorCovariance * bound.pull + priorError);
}
}  // namespace psmks
