/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/features/EdgePairing.h>
#include <psmks/joint/GaussNewton.h>

namespace psmks
{
namespace
{
constexpr double kGate_m = 0.2;
constexpr double kAcross_m = 0.01, kAlong_m = 0.05;
const Pose2 kPose{0.5, -0.2, 0.4};

DepthEdge edgeAt(const Eigen::Vector2d& point_m, int step)
{
  return {point_m, point_m.normalized(), kAcross_m * kAcross_m, kAlong_m * kAlong_m, step};
}

std::vector<RayTerm> pair(const std::vector<DepthEdge>& reference,
                          const std::vector<DepthEdge>& current, const Pose2& T_ref_cur)
{
  std::vector<RayTerm> pairs;
  const int count = pairEdges(reference, current, T_ref_cur, kGate_m, pairs);
  EXPECT_EQ(count, static_cast<int>(pairs.size()));
  return pairs;
}
}  // namespace

//   |o|    |o|    two objects with two ends each
TEST(EdgePairing, EachEndPairsWithItself)
{
  std::vector<DepthEdge> reference, current;
  for (const double y_m : {-1.0, 1.0})
    for (const int step : {-1, 1}) reference.push_back(edgeAt({3, y_m + step * 0.03}, step));
  for (const DepthEdge& edge : reference)
    current.push_back(edgeAt(kPose.inverse() * edge.point_m, edge.step));
  const std::vector<RayTerm> pairs = pair(reference, current, kPose);
  ASSERT_EQ(pairs.size(), 4U);
  for (const RayTerm& term : pairs) EXPECT_NEAR(residual(term, kPose).e, 0, 1e-9);
}

TEST(EdgePairing, EndsOfDifferentSidesAreNoPair)
{
  EXPECT_TRUE(pair({edgeAt({3, 0}, 1)}, {edgeAt({3, 0}, -1)}, {}).empty());
}

TEST(EdgePairing, EndsFartherApartThanTheGateAreNoPair)
{
  EXPECT_EQ(pair({edgeAt({3, 0}, 1)}, {edgeAt({3, 0.19}, 1)}, {}).size(), 1U);
  EXPECT_TRUE(pair({edgeAt({3, 0}, 1)}, {edgeAt({3, 0.21}, 1)}, {}).empty());
}

// Two current ends near one reference end: only the nearer one is its partner.
TEST(EdgePairing, EachIsTheNearestOneToTheOther)
{
  const std::vector<RayTerm> pairs =
      pair({edgeAt({3, 0}, 1)}, {edgeAt({3, 0.1}, 1), edgeAt({3, -0.05}, 1)}, {});
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_NEAR(residual(pairs[0], {}).e, -0.05, 1e-9);
}

// What is seen of an end is its bearing: along the line of sight it is free.
TEST(EdgePairing, APairIsHeldAcrossTheLineOfSight)
{
  const std::vector<RayTerm> pairs = pair({edgeAt({3, 0}, 1)}, {edgeAt({3, 0}, 1)}, {});
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_NEAR(residual(pairs[0], {0.1, 0, 0}).e, 0, 1e-9);
  EXPECT_NEAR(residual(pairs[0], {0, 0.1, 0}).e, 0.1, 1e-9);
  EXPECT_NEAR(1 / pairs[0].information, 2 * kAcross_m * kAcross_m, 1e-12);
}

// Seen from the other side of a right angle, what is along the one sight is across the other.
TEST(EdgePairing, TheErrorAlongTheOtherSightCountsWhereBothSightsDiffer)
{
  const std::vector<RayTerm> pairs =
      pair({edgeAt({3, 0}, 1)}, {edgeAt({2, 0}, 1)}, {3, -2, kPi / 2});
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_NEAR(1 / pairs[0].information, kAcross_m * kAcross_m + kAlong_m * kAlong_m, 1e-12);
}
}  // namespace psmks
