/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/features/CirclePairing.h>

#include <Eigen/LU>

namespace psmks
{
namespace
{
/** Largest distance of two centres that are compared. It is wider than the gate, because an error
 * of a radius moves the centre with it. Evidence: measured. */
constexpr double kReach_m = 0.5;

/** Difference of the radii beyond which two circles are not the same. Unit: standard deviations.
 * Evidence: measured. */
constexpr double kSameRadius = 3;

/** Index of the circle whose centre is nearest to a point, or -1 where none is within kReach_m. */
int nearestCircle(const std::vector<Circle>& circles, const Eigen::Vector2d& place_m)
{
  int nearest = -1;
  double best_m2 = kReach_m * kReach_m;
  for (std::size_t i = 0; i < circles.size(); ++i)
  {
    const double distance2_m2 = (circles[i].centre_m - place_m).squaredNorm();
    if (distance2_m2 >= best_m2) continue;
    best_m2 = distance2_m2;
    nearest = static_cast<int>(i);
  }
  return nearest;
}

/** Compares two circles under the condition that their radii are equal, equation (4) of
 * docs/derivations.md. The errors of a centre and of its radius are correlated, so that the
 * difference of the radii tells part of the error of the centres.
 *  @param[out] pair the corrected centres with the information of their difference
 *  @return false where the radii differ or the corrected centres are farther apart than the gate */
bool compare(const Circle& ref, const Circle& cur, const Pose2& T_ref_cur, double gate_m,
             CirclePairTerm& pair)
{
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn.topLeftCorner<2, 2>() = T_ref_cur.rotation();
  const Eigen::Matrix3d sum = ref.covariance + turn * cur.covariance * turn.transpose();
  const double differs_m = cur.radius_m - ref.radius_m;
  if (differs_m * differs_m > kSameRadius * kSameRadius * sum(2, 2)) return false;

  const Eigen::Vector2d perRadius = sum.topRightCorner<2, 1>() / sum(2, 2);
  const Eigen::Matrix2d covariance =
      sum.topLeftCorner<2, 2>() - perRadius * sum.bottomLeftCorner<1, 2>();
  pair = {ref.centre_m + perRadius * differs_m, cur.centre_m, covariance.inverse()};
  return (T_ref_cur * pair.curCentre_m - pair.refCentre_m).norm() < gate_m;
}
}  // namespace

PairedCircles pairCircles(const std::vector<Circle>& reference, const std::vector<Circle>& current,
                          const Pose2& T_ref_cur, double gate_m, std::vector<CirclePairTerm>& pairs)
{
  PairedCircles paired;
  const Pose2 T_cur_ref = T_ref_cur.inverse();
  for (std::size_t c = 0; c < current.size(); ++c)
  {
    const int nearest = nearestCircle(reference, T_ref_cur * current[c].centre_m);
    if (nearest < 0) continue;
    const auto r = static_cast<std::size_t>(nearest);
    const int back = nearestCircle(current, T_cur_ref * reference[r].centre_m);
    CirclePairTerm pair;
    if (back != static_cast<int>(c)) continue;
    if (!compare(reference[r], current[c], T_ref_cur, gate_m, pair)) continue;
    pairs.push_back(pair);
    paired.reference[r] = paired.current[c] = true;
    paired.rays += current[c].lastRay - current[c].firstRay + 1;
  }
  return paired;
}
}  // namespace psmks
