/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/features/CirclePairing.h>
#include <psmks/joint/GaussNewton.h>

#include <Eigen/LU>

namespace psmks
{
namespace
{
constexpr double kGate_m = 0.05;
const Pose2 kPose{0.5, -0.2, 0.4};

/** A circle seen from the origin of its scan: along the view, centre and radius err together. */
Circle circleAt(const Eigen::Vector2d& centre_m, double radius_m)
{
  const Eigen::Vector2d view = centre_m.normalized(), across(-view.y(), view.x());
  const Eigen::Vector3d ridge(view.x(), view.y(), 1), sideways(across.x(), across.y(), 0);
  const Eigen::Matrix3d covariance = 0.03 * 0.03 * ridge * ridge.transpose() +
                                     0.004 * 0.004 * sideways * sideways.transpose() +
                                     0.003 * 0.003 * Eigen::Matrix3d::Identity();
  return {centre_m, radius_m, covariance, 80, 89};
}

/** The same as it stands in the current scan. */
Circle seenFrom(const Pose2& T_ref_cur, const Circle& ref)
{
  return circleAt(T_ref_cur.inverse() * ref.centre_m, ref.radius_m);
}

struct Paired
{
  std::vector<CirclePairTerm> terms;
  PairedCircles circles;
};

Paired pair(const std::vector<Circle>& reference, const std::vector<Circle>& current,
            const Pose2& T_ref_cur)
{
  Paired result;
  result.circles = pairCircles(reference, current, T_ref_cur, kGate_m, result.terms);
  return result;
}
}  // namespace

//     O      O         three pillars; the current scan sees two of them, in another order
//        O
//     ^ scanner
TEST(CirclePairing, EachPairsWithItself)
{
  const std::vector<Circle> reference{circleAt({3, 1}, 0.3), circleAt({4, -1}, 0.2),
                                      circleAt({6, 2}, 0.4)};
  const std::vector<Circle> current{seenFrom(kPose, reference[2]), seenFrom(kPose, reference[0])};
  const Paired paired = pair(reference, current, kPose);
  ASSERT_EQ(paired.terms.size(), 2U);
  for (const CirclePairTerm& term : paired.terms) EXPECT_LT(residual(term, kPose).e.norm(), 1e-9);
  EXPECT_EQ(paired.circles.reference.to_ulong(), 0b101U);
  EXPECT_EQ(paired.circles.current.to_ulong(), 0b11U);
  EXPECT_EQ(paired.circles.rays, 20);
}

TEST(CirclePairing, NothingPairsBeyondTheGate)
{
  const Circle ref = circleAt({3, 1}, 0.3);
  const Circle cur = seenFrom(kPose, ref);
  EXPECT_EQ(pair({ref}, {cur}, {kPose.x_m + 0.04, kPose.y_m, kPose.phi_rad}).terms.size(), 1U);
  EXPECT_TRUE(pair({ref}, {cur}, {kPose.x_m + 0.06, kPose.y_m, kPose.phi_rad}).terms.empty());
}

TEST(CirclePairing, ALegIsNoPillar)
{
  const Circle ref = circleAt({3, 1}, 0.3);
  Circle cur = seenFrom(kPose, ref);
  cur.radius_m = 0.08;
  EXPECT_TRUE(pair({ref}, {cur}, kPose).terms.empty());
}

// Two legs side by side, one of which is hidden from the other scan: it must not lend its partner.
TEST(CirclePairing, OneCircleHasOnePartner)
{
  const Circle leg = circleAt({3, 0}, 0.08), other = circleAt({3, 0.2}, 0.08);
  const Paired paired = pair({leg}, {other, leg}, {});
  ASSERT_EQ(paired.terms.size(), 1U);
  EXPECT_EQ(paired.circles.current.to_ulong(), 0b10U);
}

// A radius that came out 3 cm too large pushed the centre 3 cm away: the pair knows.
TEST(CirclePairing, TheRadiusPutsTheCentreRight)
{
  const Circle ref = circleAt({3, 0}, 0.3);
  Circle cur = ref;
  const double off_m = 0.03;
  cur.radius_m += off_m;
  cur.centre_m.x() += off_m;
  const Paired paired = pair({ref}, {cur}, {});
  ASSERT_EQ(paired.terms.size(), 1U);
  EXPECT_LT(residual(paired.terms[0], {}).e.norm(), 0.02 * off_m);
}

// What is left is the covariance of both centres on condition that the radii are one.
TEST(CirclePairing, TheInformationIsThatOfBothAsOne)
{
  const Circle ref = circleAt({3, 1}, 0.3), cur = seenFrom(kPose, ref);
  const Paired paired = pair({ref}, {cur}, kPose);
  ASSERT_EQ(paired.terms.size(), 1U);
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn.topLeftCorner<2, 2>() = kPose.rotation();
  const Eigen::Matrix3d both = ref.covariance + turn * cur.covariance * turn.transpose();
  const Eigen::Matrix2d expected = both.inverse().topLeftCorner<2, 2>();
  EXPECT_LT((paired.terms[0].information - expected).norm(), 1e-9 * expected.norm());
}
}  // namespace psmks
