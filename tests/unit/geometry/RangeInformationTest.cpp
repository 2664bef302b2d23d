/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/geometry/Pose2.h>
#include <psmks/geometry/RangeInformation.h>

#include <Eigen/LU>
#include <functional>
#include <vector>

namespace psmks
{
namespace
{
const Pose2 kT_ref_cur{0.4, -0.3, degToRad(12)};

/** The range of a ray to a thing that a few numbers describe. */
using RangeTo = std::function<double(const Eigen::VectorXd& thing, const Eigen::Vector2d& origin_m,
                                     const Eigen::Vector2d& direction)>;

/** To a line: its distance from the origin and the angle of its normal. */
double rangeToLine_m(const Eigen::VectorXd& line, const Eigen::Vector2d& origin_m,
                     const Eigen::Vector2d& direction)
{
  const Eigen::Vector2d normal(std::cos(line[1]), std::sin(line[1]));
  return (line[0] - normal.dot(origin_m)) / normal.dot(direction);
}

/** To a circle: its radius and its centre. */
double rangeToCircle_m(const Eigen::VectorXd& circle, const Eigen::Vector2d& origin_m,
                       const Eigen::Vector2d& direction)
{
  const Eigen::Vector2d toCentre_m = circle.tail<2>() - origin_m;
  const double along_m = toCentre_m.dot(direction);
  return along_m - std::sqrt(circle[0] * circle[0] - toCentre_m.squaredNorm() + along_m * along_m);
}

/** Rays of two scans to one thing, and their derivatives by (x, y, phi) of T_ref_cur and by the
 * numbers of the thing, taken from ranges that are computed for numbers a little larger and
 * smaller. */
class Thing
{
 public:
  Thing(RangeTo rangeTo, Eigen::VectorXd numbers)
      : rangeTo_(std::move(rangeTo)), numbers_(std::move(numbers))
  {
  }

  void see(bool fromCurrent, double bearing_rad, double weight = 1)
  {
    rays_.push_back({fromCurrent, bearing_rad, weight});
  }

  double range_m(std::size_t ray, const Pose2& T, const Eigen::VectorXd& numbers) const
  {
    const Pose2 from = rays_[ray].fromCurrent ? T : Pose2{};
    const double heading_rad = from.phi_rad + rays_[ray].bearing_rad;
    return rangeTo_(numbers, from.translation(), {std::cos(heading_rad), std::sin(heading_rad)});
  }

  SurfaceRay surfaceRay(std::size_t ray, double noise_m) const
  {
    const Pose2 from = rays_[ray].fromCurrent ? kT_ref_cur : Pose2{};
    const double heading_rad = from.phi_rad + rays_[ray].bearing_rad;
    return {from.translation(),
            {std::cos(heading_rad), std::sin(heading_rad)},
            range_m(ray, kT_ref_cur, numbers_),
            noise_m,
            rays_[ray].fromCurrent,
            rays_[ray].weight};
  }

  Eigen::VectorXd derivative(std::size_t ray) const
  {
    constexpr double h = 1e-6;
    Eigen::VectorXd J(3 + numbers_.size());
    for (Eigen::Index k = 0; k < J.size(); ++k)
    {
      const auto changed = [&](double by)
      {
        Pose2 T = kT_ref_cur;
        Eigen::VectorXd numbers = numbers_;
        (k == 0 ? T.x_m : k == 1 ? T.y_m : k == 2 ? T.phi_rad : numbers[k - 3]) += by;
        return range_m(ray, T, numbers);
      };
      J[k] = (changed(h) - changed(-h)) / (2 * h);
    }
    return J;
  }

  /** What is left for the pose once the numbers of the thing have been estimated too. */
  Eigen::Matrix3d information() const
  {
    const Eigen::Index all = 3 + numbers_.size();
    Eigen::MatrixXd H = Eigen::MatrixXd::Zero(all, all);
    for (std::size_t i = 0; i < rays_.size(); ++i)
      H += rays_[i].weight * derivative(i) * derivative(i).transpose();
    const Eigen::Index n = numbers_.size();
    return H.topLeftCorner(3, 3) -
           H.topRightCorner(3, n) * H.bottomRightCorner(n, n).inverse() * H.bottomLeftCorner(n, 3);
  }

  std::size_t size() const { return rays_.size(); }
  const Eigen::VectorXd& numbers() const { return numbers_; }

 private:
  struct Ray
  {
    bool fromCurrent;
    double bearing_rad, weight;
  };
  RangeTo rangeTo_;
  Eigen::VectorXd numbers_;
  std::vector<Ray> rays_;
};

SurfaceContact contactOf(const Thing& thing, const SurfaceRay& ray)
{
  const Eigen::Vector2d contact_m = ray.origin_m + ray.range_m * ray.direction;
  const Eigen::VectorXd& n = thing.numbers();
  if (n.size() == 3) return SurfaceContact::onCircle(n.tail<2>(), contact_m);
  const Eigen::Vector2d normal(std::cos(n[1]), std::sin(n[1]));
  return SurfaceContact::onLine(normal, n[0] * normal, contact_m);
}

/** @param noise_m of a ray */
void add(
    const Thing& thing, PoseInformation& total,
    const std::function<double(std::size_t)>& noise_m = [](std::size_t) { return 0.0; })
{
  RangeInformation information;
  for (std::size_t i = 0; i < thing.size(); ++i)
  {
    const SurfaceRay ray = thing.surfaceRay(i, noise_m(i));
    information.add(ray, contactOf(thing, ray));
  }
  information.addTo(total);
}

/** A wall whose nearest point lies at a bearing, seen by nine rays of either scan about there. */
Thing wall(double distance_m, double bearing_deg)
{
  Thing thing(rangeToLine_m, Eigen::Vector2d(distance_m, degToRad(bearing_deg)));
  for (int k = -4; k <= 4; ++k)
  {
    thing.see(false, degToRad(bearing_deg + 8 * k));
    thing.see(true, degToRad(bearing_deg - 12 + 7 * k), 0.5 + 0.1 * k);
  }
  return thing;
}

/** A pillar of 30 cm radius, 2 m ahead, seen by six rays of either scan. */
Thing pillar()
{
  Thing thing(rangeToCircle_m, Eigen::Vector3d(0.3, 2, 0.1));
  for (int k = 0; k < 6; ++k)
  {
    thing.see(false, degToRad(-2 + 2 * k));
    thing.see(true, degToRad(-3 + 2.5 * k));
  }
  return thing;
}

double relativeError(const Eigen::Matrix3d& actual, const Eigen::Matrix3d& expected)
{
  return (actual - expected).norm() / expected.norm();
}
}  // namespace

TEST(RangeInformation, OfALineIsWhatItsOwnUnknownsLeave)
{
  for (const double bearing_deg : {0.0, 70.0, 180.0, -120.0})
  {
    PoseInformation total;
    add(wall(2.5, bearing_deg), total);
    EXPECT_LT(relativeError(total.information, wall(2.5, bearing_deg).information()), 1e-6)
        << bearing_deg << " deg";
  }
}

TEST(RangeInformation, OfACircleIsWhatItsOwnUnknownsLeave)
{
  PoseInformation total;
  add(pillar(), total);
  EXPECT_LT(relativeError(total.information, pillar().information()), 1e-6);
}

TEST(RangeInformation, OfManyThingsAddsUp)
{
  PoseInformation total;
  Eigen::Matrix3d expected = Eigen::Matrix3d::Zero();
  for (const Thing& thing : {wall(2, 10), wall(3, 100), pillar()})
  {
    add(thing, total);
    expected += thing.information();
  }
  EXPECT_LT(relativeError(total.information, expected), 1e-6);
}

// Noise that looks like an error of the pose, and of the walls beside, pulls the pose by it.
TEST(RangeInformation, ThePullIsThatOfTheNoise)
{
  const Eigen::Vector3d error(0.002, -0.003, 0.001);
  const Eigen::Vector2d errorOfWall(0.004, -0.002);
  PoseInformation total;
  for (const Thing& thing : {wall(2, 10), wall(3, 100), wall(4, -100)})
    add(thing, total,
        [&](std::size_t ray)
        {
          const Eigen::VectorXd J = thing.derivative(ray);
          return J.head<3>().dot(error) + J.tail<2>().dot(errorOfWall);
        });
  const Eigen::Vector3d found = total.information.inverse() * total.pull;
  EXPECT_LT((found - error).norm(), 1e-6 * error.norm());
}

TEST(RangeInformation, OneScanAloneSaysNothing)
{
  for (const bool fromCurrent : {false, true})
  {
    Thing alone(rangeToLine_m, Eigen::Vector2d(2, 0));
    for (int k = -4; k <= 4; ++k) alone.see(fromCurrent, degToRad(5 * k));
    PoseInformation total;
    add(alone, total);
    EXPECT_EQ(total.information, Eigen::Matrix3d::Zero().eval());
  }
}

// A line has two unknowns: two rays are explained by it whatever the pose, the third tells.
TEST(RangeInformation, AsManyRaysAsUnknownsSayNothing)
{
  Thing thing(rangeToLine_m, Eigen::Vector2d(2, 0));
  thing.see(false, 0.1);
  thing.see(true, -0.1);
  PoseInformation two;
  add(thing, two);
  EXPECT_EQ(two.information, Eigen::Matrix3d::Zero().eval());
  thing.see(false, -0.2);
  PoseInformation three;
  add(thing, three);
  EXPECT_GT(three.information.trace(), 0);
}

TEST(RangeInformation, ARayThatGrazesSaysNothing)
{
  PoseInformation without, with;
  add(wall(2.5, 0), without);
  RangeInformation information;
  const Thing thing = wall(2.5, 0);
  for (std::size_t i = 0; i < thing.size(); ++i)
    information.add(thing.surfaceRay(i, 0), contactOf(thing, thing.surfaceRay(i, 0)));
  const SurfaceRay grazing{{2.5, 0}, {0, 1}, 3, 0.1, true};
  information.add(grazing, SurfaceContact::onLine({1, 0}, {2.5, 0}, {2.5, 3}));
  information.addTo(with);
  EXPECT_EQ(with.information, without.information);
}
}  // namespace psmks
