/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/geometry/Covariance.h>
#include <tests/support/RandomNumbers.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>

namespace psmks
{
namespace
{
using Eigen::Matrix3d;

/** A covariance with axes that point anywhere. */
Matrix3d randomCovariance(test::RandomNumbers& random, double leastExponent, double largestExponent)
{
  const Matrix3d any = Matrix3d::NullaryExpr([&] { return random.normal(1); });
  const Matrix3d axes =
      Eigen::SelfAdjointEigenSolver<Matrix3d>(any + any.transpose()).eigenvectors();
  const Eigen::Vector3d variances = Eigen::Vector3d::NullaryExpr(
      [&] { return std::pow(10, random.uniform(leastExponent, largestExponent)); });
  return axes * variances.asDiagonal() * axes.transpose();
}

void expectValid(const Matrix3d& covariance)
{
  EXPECT_TRUE(covariance.allFinite()) << covariance;
  EXPECT_EQ(covariance, covariance.transpose()) << covariance;
  EXPECT_EQ(covariance.llt().info(), Eigen::Success) << covariance;
  const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(covariance);
  EXPECT_GT(axes.eigenvalues()[0], 0) << covariance;
  EXPECT_LE(axes.eigenvalues()[2], kVaguest * (1 + 1e-9)) << covariance;
}
}  // namespace

TEST(Covariance, IsFiniteSymmetricAndPositiveDefinite)
{
  EXPECT_TRUE(isCovariance(Matrix3d::Identity()));
  EXPECT_FALSE(isCovariance(Matrix3d::Zero()));
  EXPECT_FALSE(isCovariance(-Matrix3d::Identity()));
  Matrix3d matrix = Matrix3d::Identity();
  matrix(0, 1) = 0.1;
  EXPECT_FALSE(isCovariance(matrix)) << "not symmetric";
  matrix(1, 0) = 0.1 + 1e-12;
  EXPECT_TRUE(isCovariance(matrix)) << "rounding";
  matrix(2, 2) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(isCovariance(matrix));
}

TEST(BoundedCovariance, LeavesAnOrdinaryOneAsItIs)
{
  test::RandomNumbers random(7);
  SCOPED_TRACE(random.seedText());
  for (int i = 0; i < 1000; ++i)
  {
    const Matrix3d any = randomCovariance(random, -6, 2);
    const Matrix3d symmetric = any.selfadjointView<Eigen::Lower>();
    EXPECT_EQ(boundedCovariance(symmetric), symmetric);
  }
}

TEST(BoundedCovariance, IsValidForEveryFiniteOne)
{
  test::RandomNumbers random(8);
  SCOPED_TRACE(random.seedText());
  for (int i = 0; i < 20000; ++i)
    expectValid(boundedCovariance(randomCovariance(random, -40, random.uniform(-30, 250))));
  expectValid(boundedCovariance(1e18 * Matrix3d::Identity()));
  expectValid(boundedCovariance(1e-300 * Matrix3d::Identity()));
  expectValid(boundedCovariance(Matrix3d::Ones()));
}

TEST(BoundedCovariance, OfAVagueAxisKeepsWhatIsKnownOfTheOthers)
{
  const Matrix3d bounded = boundedCovariance(Eigen::Vector3d(1e18, 1e-4, 1e-6).asDiagonal());
  EXPECT_NEAR(bounded(0, 0), kVaguest, 1e-6 * kVaguest);
  EXPECT_NEAR(bounded(1, 1), 1e-4, 1e-7);
  EXPECT_NEAR(bounded(2, 2), 1e-6, 1e-7);
}

TEST(BoundedCovariance, OfNothingIsNothing)
{
  EXPECT_TRUE(boundedCovariance(Matrix3d::Zero()).isZero(0));
}
}  // namespace psmks
