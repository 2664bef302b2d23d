/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/geometry/Observability.h>
#include <psmks/joint/OpenDirections.h>
#include <tests/support/RandomNumbers.h>

#include <Eigen/LU>

namespace psmks
{
namespace
{
class OpenDirections : public testing::Test
{
 protected:
  /** J'J and J'e of random rows. */
  NormalEquations randomEquations()
  {
    NormalEquations scans;
    for (int k = 0; k < 6; ++k)
    {
      const Eigen::Vector3d row(random_.normal(100), random_.normal(100), random_.normal(100));
      scans.H += row * row.transpose();
      scans.g += row * random_.normal(1);
    }
    return scans;
  }

  Eigen::Vector2d randomDirection()
  {
    const double angle_rad = random_.uniform(-kPi, kPi);
    return {std::cos(angle_rad), std::sin(angle_rad)};
  }

  test::RandomNumbers random_{3};
};
}  // namespace

// In axes along and across the direction, what is known of the rest is the rest of the inverse.
TEST_F(OpenDirections, WithoutADirectionTheRestIsKnownAsWithThatDirectionUnknown)
{
  SCOPED_TRACE(random_.seedText());
  for (int i = 0; i < 100; ++i)
  {
    const NormalEquations scans = randomEquations();
    const Eigen::Vector2d u = randomDirection();
    const NormalEquations rest = withoutDirection(scans, u);
    EXPECT_LT((rest.H * Eigen::Vector3d(u.x(), u.y(), 0)).norm(), 1e-9 * scans.H.norm());

    Eigen::Matrix<double, 3, 2> others;
    others << -u.y(), 0, u.x(), 0, 0, 1;
    const Eigen::Matrix2d marginal = others.transpose() * scans.H.inverse() * others;
    EXPECT_TRUE((others.transpose() * rest.H * others).inverse().isApprox(marginal, 1e-6));

    const Eigen::Vector2d all = others.transpose() * scans.H.inverse() * scans.g;
    const Eigen::Vector2d left =
        (others.transpose() * rest.H * others).inverse() * (others.transpose() * rest.g);
    EXPECT_TRUE(left.isApprox(all, 1e-6)) << "the optimum across moved";
  }
}

TEST_F(OpenDirections, ADirectionOfWhichNothingIsKnownChangesNothing)
{
  const NormalEquations scans{Eigen::Vector3d(0, 1e4, 1e4).asDiagonal(), {0, 1, 2}};
  const NormalEquations rest = withoutDirection(scans, {1, 0});
  EXPECT_EQ(rest.H, scans.H);
  EXPECT_EQ(rest.g, scans.g);
}

TEST_F(OpenDirections, WithoutTheHeadingThePositionAtAHeadingIsKnownAsBefore)
{
  SCOPED_TRACE(random_.seedText());
  for (int i = 0; i < 100; ++i)
  {
    const NormalEquations scans = randomEquations();
    const NormalEquations rest = withoutHeading(scans);
    EXPECT_EQ((rest.H.topLeftCorner<2, 2>()), (scans.H.topLeftCorner<2, 2>()));
    Eigen::Vector3d turn;
    turn << positionPerHeading(scans.H), 1;
    EXPECT_LT((rest.H * turn).norm(), 1e-9 * scans.H.norm() * turn.norm());
    EXPECT_NEAR(rest.g.dot(turn), 0, 1e-9 * rest.g.norm() * turn.norm());
  }
}
}  // namespace psmks
