/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/geometry/UncertainPose.h>
#include <tests/support/PoseMatcher.h>
#include <tests/unit/geometry/UncertainMotion.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <functional>

namespace psmks::test
{
namespace
{
/** Derivative of a pose by another one, by central differences. */
Eigen::Matrix3d numericJacobian(const Pose2& at, const std::function<Pose2(const Pose2&)>& f)
{
  constexpr double kStep = 1e-6;
  const auto moved = [&](int axis, double h)
  {
    Eigen::Vector3d v(at.x_m, at.y_m, at.phi_rad);
    v[axis] += h;
    const Pose2 pose = f({v.x(), v.y(), v.z()});
    return Eigen::Vector3d(pose.x_m, pose.y_m, pose.phi_rad);
  };
  Eigen::Matrix3d J;
  for (int axis = 0; axis < 3; ++axis)
    J.col(axis) = (moved(axis, kStep) - moved(axis, -kStep)) / (2 * kStep);
  return J;
}

/** Tolerance of covariances: above the error of the central differences. */
constexpr double kTolerance = 1e-11;
}  // namespace

TEST(UncertainPose, ComposedMovesBothCovariancesAsTheNumericJacobiansDo)
{
  const UncertainPose a = someMotion(), b{kCur, 2 * a.covariance};
  const auto byA = [&](const Pose2& T) { return T * b.pose; };
  const auto byB = [&](const Pose2& T) { return a.pose * T; };
  const Eigen::Matrix3d J_a = numericJacobian(a.pose, byA), J_b = numericJacobian(b.pose, byB);
  const Eigen::Matrix3d expected =
      J_a * a.covariance * J_a.transpose() + J_b * b.covariance * J_b.transpose();
  EXPECT_LT((composed(a, b).covariance - expected).norm(), kTolerance);
}

TEST(UncertainPose, SeenFromMovesBothCovariancesAsTheNumericJacobiansDo)
{
  const UncertainPose a = someMotion(), b{kCur, 2 * a.covariance};
  const auto byA = [&](const Pose2& T) { return T.inverse() * b.pose; };
  const auto byB = [&](const Pose2& T) { return a.pose.inverse() * T; };
  const Eigen::Matrix3d J_a = numericJacobian(a.pose, byA), J_b = numericJacobian(b.pose, byB);
  const Eigen::Matrix3d expected =
      J_a * a.covariance * J_a.transpose() + J_b * b.covariance * J_b.transpose();
  EXPECT_LT((seenFrom(a, b).covariance - expected).norm(), kTolerance);
}

TEST(UncertainPose, ConjugatedMovesTheCovarianceAsTheNumericJacobianDoes)
{
  const UncertainPose motion = someMotion();
  const auto byMotion = [](const Pose2& T) { return conjugated({T, {}}, kRef, kCur).pose; };
  const Eigen::Matrix3d J = numericJacobian(motion.pose, byMotion);
  const Eigen::Matrix3d expected = J * motion.covariance * J.transpose();
  EXPECT_LT((conjugated(motion, kRef, kCur).covariance - expected).norm(), kTolerance);
}

TEST(UncertainPose, ConjugatedIsUndoneByTheInverseMountings)
{
  const UncertainPose motion = someMotion();
  const UncertainPose back =
      conjugated(conjugated(motion, kRef, kCur), kRef.inverse(), kCur.inverse());
  EXPECT_TRUE(isNearly(back.pose, motion.pose, 1e-12, 1e-12));
  EXPECT_LT((back.covariance - motion.covariance).norm(), 1e-15);
}

TEST(FusedCovariance, IsTheInverseOfTheSumOfInformation)
{
  const Eigen::Matrix3d guess = Eigen::Vector3d(0.04, 0.01, 0.0025).asDiagonal();
  Eigen::Matrix3d information;
  information << 900, 30, -20, 30, 400, 50, -20, 50, 2500;
  const Eigen::Matrix3d expected = (guess.inverse() + information).inverse();
  EXPECT_TRUE(fusedCovariance(guess, information).isApprox(expected, 1e-12));
}

// A corridor along 30 degrees, and a guess that knows next to nothing: what rounding leaves of the
// information along it is more than the guess has.
TEST(FusedCovariance, IsPositiveDefiniteAlsoForAVagueGuess)
{
  const Eigen::Vector3d across(-0.5, std::sqrt(0.75), 0.3);
  const Eigen::Matrix3d information =
      1e7 * across * across.transpose() + Eigen::Vector3d(0, 0, 1e6).asDiagonal().toDenseMatrix();
  for (const double variance : {1., 1e3, 1e6})
  {
    const Eigen::Matrix3d fused =
        fusedCovariance(variance * Eigen::Matrix3d::Identity(), information);
    EXPECT_EQ(fused.llt().info(), Eigen::Success) << variance;
    EXPECT_TRUE(fused.allFinite()) << variance;
  }
}
TEST(InformationBeyond, IsWhatWasFusedWithTheGuess)
{
  const Eigen::Matrix3d guess = someMotion().covariance;
  Eigen::Matrix3d information;
  information << 1e5, 2e3, 1e3, 2e3, 5e4, 0, 1e3, 0, 3e5;
  const Eigen::Matrix3d found = informationBeyond(guess, fusedCovariance(guess, information));
  EXPECT_TRUE(found.isApprox(information, 1e-6));
}

// Along a corridor the fused variance is that of the guess: the scans knew nothing there.
TEST(InformationBeyond, OfADirectionThatStaysAsItWasIsNone)
{
  const Eigen::Matrix3d guess = Eigen::Vector3d(0.25, 0.25, 0.03).asDiagonal();
  const Eigen::Matrix3d fused = Eigen::Vector3d(0.25, 1e-4, 1e-6).asDiagonal();
  const Eigen::Matrix3d found = informationBeyond(guess, fused);
  EXPECT_NEAR(found(0, 0), 0, 1e-9);
  EXPECT_NEAR(found(1, 1), 1e4 - 4, 1e-6);
  const Eigen::Matrix3d wider = Eigen::Vector3d(0.3, 1e-4, 1e-6).asDiagonal();
  EXPECT_NEAR(informationBeyond(guess, wider)(0, 0), 0, 1e-9) << "and never less than none";
}
}  // namespace psmks::test
