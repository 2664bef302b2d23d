/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/geometry/Angle.h>
#include <psmks/geometry/Observability.h>
#include <tests/support/RandomNumbers.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <limits>

namespace psmks
{
namespace
{
/** J'J of random rows: symmetric, positive definite. */
Eigen::Matrix3d randomInformation(test::RandomNumbers& random)
{
  Eigen::Matrix<double, 6, 3> J;
  for (int i = 0; i < J.size(); ++i) J(i / 3, i % 3) = random.normal(100);
  return J.transpose() * J;
}
}  // namespace

// The marginal covariance of the position is the corner of the whole inverse; its larger eigenvalue
// is what is known worst.
TEST(Observability, AgreesWithTheEigenvaluesOfTheMarginalCovariance)
{
  test::RandomNumbers random(51);
  SCOPED_TRACE(random.seedText());
  for (int i = 0; i < 1000; ++i)
  {
    const Eigen::Matrix3d H = randomInformation(random);
    const Eigen::Matrix3d P = H.inverse();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> position(P.topLeftCorner<2, 2>());
    const Observability o = observability(H);
    EXPECT_NEAR(o.weakSigma_m / std::sqrt(position.eigenvalues()[1]), 1, 1e-6);
    EXPECT_NEAR(std::abs(o.weakDirection.dot(position.eigenvectors().col(1))), 1, 1e-6);
    EXPECT_NEAR(o.weakDirection.norm(), 1, 1e-12);
    EXPECT_NEAR(o.headingSigma_rad / std::sqrt(P(2, 2)), 1, 1e-6);
  }
}

//  -------------- corridor: every row of J is (n, .), with n across
TEST(Observability, ACorridorLeavesItsOwnDirectionOpen)
{
  for (const double along_deg : {0., 30., 90., 179.})
  {
    const Eigen::Vector2d along(std::cos(degToRad(along_deg)), std::sin(degToRad(along_deg)));
    const Eigen::Vector2d across(-along.y(), along.x());
    Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
    for (const double lever_m : {-2., -1., 1., 2.})
    {
      const Eigen::Vector3d row(across.x(), across.y(), lever_m);
      H += 1e4 * row * row.transpose();
    }
    const Observability o = observability(H);
    EXPECT_GT(o.weakSigma_m, 1e3);
    EXPECT_NEAR(std::abs(o.weakDirection.dot(along)), 1, 1e-9) << along_deg << " deg";
    EXPECT_LT(o.headingSigma_rad, 0.01);
  }
}

// One wall, all of it to one side: rounding leaves a little information along it, which must not be
// taken for a position that explains the heading.
TEST(Observability, ASingleWallFixesTheHeading)
{
  for (int along_deg = 0; along_deg < 180; ++along_deg)
  {
    const double across_rad = degToRad(along_deg + 90);
    Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
    for (const double lever_m : {8., 9., 10., 11.})
    {
      const Eigen::Vector3d row(std::cos(across_rad), std::sin(across_rad), lever_m);
      H += 1e4 * row * row.transpose();
    }
    EXPECT_NEAR(observability(H).headingSigma_rad, 1 / std::sqrt(1e4 * 5), 1e-6) << along_deg;
  }
}

TEST(Observability, ARoundRoomLeavesTheHeadingOpen)
{
  const Observability o = observability(Eigen::Vector3d(1e4, 1e4, 0).asDiagonal());
  EXPECT_NEAR(o.weakSigma_m, 0.01, 1e-9);
  EXPECT_TRUE(std::isinf(o.headingSigma_rad));
}

TEST(Observability, NothingIsKnownWithoutInformation)
{
  const Observability o = observability(Eigen::Matrix3d::Zero());
  EXPECT_TRUE(std::isinf(o.weakSigma_m));
  EXPECT_TRUE(std::isinf(o.headingSigma_rad));
  EXPECT_NEAR(o.weakDirection.norm(), 1, 1e-12);
}

// One landmark, at p in the reference frame and at q in the current one: whatever the heading, the
// position that suits it puts q on p.
TEST(Observability, ATurnToAnotherHeadingKeepsWhatTheScansFix)
{
  const Eigen::Vector2d q_m(2, 1);
  const Pose2 T_ref_cur{0.3, -0.2, 0.4};
  const Eigen::Vector2d p_m = T_ref_cur.rotation() * q_m + T_ref_cur.translation();
  Eigen::Matrix<double, 2, 3> J;
  J << Eigen::Matrix2d::Identity(), T_ref_cur.rotationDerivative() * q_m;
  const Eigen::Matrix3d H = 1e4 * J.transpose() * J;
  EXPECT_LT((positionPerHeading(H) + J.col(2)).norm(), 1e-12);
  constexpr double kAnySigma_m = std::numeric_limits<double>::infinity();
  for (const double phi_rad : {-2., 0., 0.4, 3.})
  {
    const Pose2 turned = turnedTo(phi_rad, T_ref_cur, H, kAnySigma_m);
    EXPECT_EQ(turned.phi_rad, phi_rad);
    EXPECT_LT((turned.rotation() * q_m + turned.translation() - p_m).norm(), 1e-9) << phi_rad;
  }
}

// The position is fixed well along y and hardly along x, to 1 m, where the heading seems to move it
// by 40 m a radian: a turn leaves it where it is along x.
TEST(Observability, ATurnMovesNothingAlongADirectionThatIsHardlyFixed)
{
  Eigen::Matrix3d H = Eigen::Vector3d(1, 1e4, 1e4).asDiagonal();
  H(0, 2) = H(2, 0) = -40;
  H(1, 2) = H(2, 1) = -2e4;
  EXPECT_LT((positionPerHeading(H) - Eigen::Vector2d(40, 2)).norm(), 1e-9);
  EXPECT_LT((positionPerHeading(H, 0.05) - Eigen::Vector2d(0, 2)).norm(), 1e-9);
  const Pose2 turned = turnedTo(0.1, {}, H, 0.05);
  EXPECT_LT(turned.translation().norm(), 0.21);
}

TEST(Observability, AtAHeadingTwoWallsFixThePositionAndOneDoesNot)
{
  Eigen::Matrix3d H = Eigen::Vector3d(1e4, 1e4, 0).asDiagonal();
  EXPECT_NEAR(observabilityAtHeading(H).weakSigma_m, 0.01, 1e-9);
  H(1, 1) = 0;
  EXPECT_TRUE(std::isinf(observabilityAtHeading(H).weakSigma_m));
}
}  // namespace psmks
