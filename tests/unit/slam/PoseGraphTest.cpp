/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/slam/PoseGraph.h>
#include <tests/support/PoseMatcher.h>

namespace psmks
{
namespace
{
Eigen::Matrix3d information(double sigma_m, double sigma_rad = degToRad(0.1))
{
  const double position = 1 / (sigma_m * sigma_m), heading = 1 / (sigma_rad * sigma_rad);
  return Eigen::Vector3d(position, position, heading).asDiagonal();
}

/** What the true poses say, displaced by an error in the axes of `from`. */
PoseLink linkOf(const std::vector<Pose2>& truth, std::size_t from, std::size_t to,
                const Eigen::Vector3d& error = Eigen::Vector3d::Zero())
{
  const Pose2 T = truth[from].inverse() * truth[to];
  return {from, to, Pose2{T.x_m + error.x(), T.y_m + error.y(), wrapAngle(T.phi_rad + error.z())},
          information(0.01)};
}

//     3 <---- 2        a drive around a block by a robot that looks to the right of its way; the
//     |       ^        first pose is not at the origin, and the headings pass 180 degrees
//     v       |
//     0 ----> 1
const std::vector<Pose2> kBlock{{5, -2, degToRad(40)},
                                {4.5, 1, degToRad(130)},
                                {1.5, 0.5, degToRad(-140)},
                                {2, -2.5, degToRad(-50)}};

PoseGraph graphAt(const std::vector<Pose2>& poses)
{
  PoseGraph graph;
  for (const Pose2& pose : poses) graph.add(pose);
  return graph;
}

void tieAround(PoseGraph& graph)
{
  for (std::size_t node = 0; node < kBlock.size(); ++node)
    graph.add(linkOf(kBlock, node, (node + 1) % kBlock.size()));
}

void expectPoses(const PoseGraph& graph, const std::vector<Pose2>& expected, double tol)
{
  ASSERT_EQ(graph.poses().size(), expected.size());
  for (std::size_t node = 0; node < expected.size(); ++node)
    EXPECT_TRUE(isNearly(graph.poses()[node], expected[node], tol, tol)) << "node " << node;
}

/** Cost that the kernel makes of the links, summed: 9 / 2 log(1 + s / 9), s the squared distance of
 *  a link in standard deviations. */
double costOf(const std::vector<PoseLink>& links, const std::vector<Pose2>& poses)
{
  constexpr double kWidth2 = 9;
  double cost = 0;
  for (const PoseLink& link : links)
  {
    const Pose2 between = poses[link.from].inverse() * poses[link.to];
    const Eigen::Vector3d error(between.x_m - link.T_from_to.x_m, between.y_m - link.T_from_to.y_m,
                                wrapAngle(between.phi_rad - link.T_from_to.phi_rad));
    cost += kWidth2 / 2 * std::log1p(error.dot(link.information * error) / kWidth2);
  }
  return cost;
}

double& coordinate(Pose2& pose, int k)
{
  return k == 0 ? pose.x_m : k == 1 ? pose.y_m : pose.phi_rad;
}
}  // namespace

TEST(PoseGraph, WhatAgreesStays)
{
  PoseGraph graph = graphAt(kBlock);
  tieAround(graph);
  graph.optimise();
  expectPoses(graph, kBlock, 1e-9);
}

TEST(PoseGraph, PosesFromAwayFallIntoPlace)
{
  std::vector<Pose2> guesses = kBlock;
  guesses[1] = guesses[1] * Pose2{0.05, -0.04, degToRad(1.5)};
  guesses[2] = guesses[2] * Pose2{-0.07, 0.03, degToRad(-2)};
  guesses[3] = guesses[3] * Pose2{0.02, 0.06, degToRad(1)};
  PoseGraph graph = graphAt(guesses);
  tieAround(graph);
  graph.optimise();
  expectPoses(graph, kBlock, 1e-6);
}

//     0 --1 m-- 1 --1 m-- 2      two links say 2 m, a third one 2 m and 4 mm: each gives way by its
//      \_____2.004 m_____/       share of the variance, 1 : 1 : 2
TEST(PoseGraph, ALoopSharesItsErrorByTheInformation)
{
  PoseGraph graph = graphAt({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
  graph.add({0, 1, {1, 0, 0}, information(0.01)});
  graph.add({1, 2, {1, 0, 0}, information(0.01)});
  graph.add({0, 2, {2.004, 0, 0}, information(0.01 * std::sqrt(2.0))});
  graph.optimise();
  expectPoses(graph, {{0, 0, 0}, {1.001, 0, 0}, {2.002, 0, 0}}, 2e-5);
}

// Around the block three links know the truth, and what each of them says of the loop is turned
// into its own axes: the sum of squares has its minimum where its derivatives are zero.
TEST(PoseGraph, TheResultIsTheMinimumOfItsCost)
{
  const std::vector<PoseLink> links{
      linkOf(kBlock, 0, 1, {0.02, -0.01, degToRad(0.1)}), linkOf(kBlock, 1, 2),
      linkOf(kBlock, 2, 3, {-0.01, 0.02, degToRad(-0.2)}), linkOf(kBlock, 3, 0),
      linkOf(kBlock, 0, 2, {0.01, 0.01, degToRad(0.1)})};
  PoseGraph graph = graphAt(kBlock);
  for (const PoseLink& link : links) graph.add(link);
  graph.optimise();

  constexpr double kStep = 1e-5;
  for (std::size_t node = 1; node < kBlock.size(); ++node)
    for (int k = 0; k < 3; ++k)
    {
      std::vector<Pose2> more = graph.poses(), less = graph.poses();
      coordinate(more[node], k) += kStep;
      coordinate(less[node], k) -= kStep;
      const double here = costOf(links, graph.poses());
      const double slope = (costOf(links, more) - costOf(links, less)) / (2 * kStep);
      const double bend = (costOf(links, more) + costOf(links, less) - 2 * here) / (kStep * kStep);
      EXPECT_GT(bend, 0);
      // how far the minimum is from here, in metres or radians
      EXPECT_NEAR(slope / bend, 0, 2e-5) << "node " << node << ", coordinate " << k;
    }
}

// Three links hold a node 1 m ahead; a wrong match holds it at 2 m, as certain as the others.
TEST(PoseGraph, AWrongLinkIsOutvoted)
{
  PoseGraph graph = graphAt({{0, 0, 0}, {1.1, 0.1, 0}});
  for (int link = 0; link < 3; ++link) graph.add({0, 1, {1, 0, 0}, information(0.01)});
  graph.add({0, 1, {2, 0.5, degToRad(3)}, information(0.01)});
  graph.optimise();
  EXPECT_TRUE(isNearly(graph.poses()[1], {1, 0, 0}, 0.001, degToRad(0.01)));
}

//     0 - 1 - 2 - ... - 40      every step drifts by 2.5 cm to the left; then the last node is
//     known
//      \_______________/        from the first: 1 m of contradiction, which all steps share
TEST(PoseGraph, ALoopThatClosesTakesAwayTheDrift)
{
  PoseGraph graph;
  graph.add(Pose2());
  for (std::size_t node = 1; node <= 40; ++node)
  {
    graph.add(Pose2{static_cast<double>(node), 0.025 * static_cast<double>(node), 0});
    graph.add({node - 1, node, {1, 0.025, 0}, information(0.02)});
  }
  graph.optimise();
  graph.add({0, 40, {40, 0, 0}, information(0.02)});
  graph.optimise();
  EXPECT_TRUE(isNearly(graph.poses()[40], {40, 0, 0}, 0.05, degToRad(0.5)));
  EXPECT_TRUE(isNearly(graph.poses()[20], {20, 0, 0}, 0.3, degToRad(2)));
}

TEST(PoseGraph, FixedNodesStay)
{
  std::vector<Pose2> guesses = kBlock;
  guesses[1].x_m += 0.1;
  guesses[3].y_m += 0.1;
  PoseGraph graph = graphAt(guesses);
  tieAround(graph);
  graph.optimise(2);
  EXPECT_TRUE(isNearly(graph.poses()[1], guesses[1], 0, 0));
  EXPECT_FALSE(isNearly(graph.poses()[3], guesses[3], 0.01, degToRad(1)));
}

TEST(PoseGraph, ANodeWithoutALinkStays)
{
  std::vector<Pose2> poses = kBlock;
  poses.push_back({7, 7, 1});
  poses.push_back({8, 7, 1});
  PoseGraph graph = graphAt(poses);
  tieAround(graph);
  graph.optimise();
  expectPoses(graph, poses, 1e-9);
}

// The link puts 1 to the left of where 0 stands, whichever way 0 looks.
TEST(PoseGraph, TheFirstNodeStaysAndItsHeadingCounts)
{
  const Pose2 first{3, 4, degToRad(179)};
  PoseGraph graph = graphAt({first, first * Pose2{0.1, 0.9, degToRad(3)}});
  graph.add({0, 1, {0, 1, degToRad(5)}, information(0.01)});
  graph.optimise();
  EXPECT_TRUE(isNearly(graph.poses()[0], first, 0, 0));
  EXPECT_TRUE(isNearly(graph.poses()[1], first * Pose2{0, 1, degToRad(5)}, 1e-6, 1e-6));
}

TEST(PoseGraph, FewerThanTwoNodesAreLeftAlone)
{
  PoseGraph graph;
  graph.optimise();
  EXPECT_TRUE(graph.poses().empty());
  EXPECT_EQ(graph.add(Pose2{1, 2, 3}), 0U);
  EXPECT_EQ(graph.add(Pose2{4, 5, 1}), 1U);
  graph.optimise();
  EXPECT_TRUE(isNearly(graph.poses()[1], {4, 5, 1}, 0, 0));
}

//     0 ---- 1 ---- 2      each link leaves 1 cm open in x and in y, and 0.1 degrees; the short cut
//      \           /       from 0 to 3 leaves 1 m open; nothing leads to 4
//       '---- 3 --'    4
class KnownNodes : public testing::Test
{
 protected:
  KnownNodes()
  {
    for (const Pose2& pose : {Pose2{}, Pose2{2, 0, 0}, Pose2{4, 0, 0}, Pose2{2, -1, 0}, Pose2{}})
      graph_.add(pose);
    add(0, 1, 0.01);
    add(1, 2, 0.01);
    add(2, 3, 0.01);
    add(0, 3, 1);
  }

  void add(std::size_t from, std::size_t to, double sigma_m)
  {
    const Pose2 T_from_to = graph_.poses()[from].inverse() * graph_.poses()[to];
    const double variance_rad2 = std::pow(degToRad(0.1), 2);
    graph_.add({from, to, T_from_to,
                Eigen::Vector3d(1 / (sigma_m * sigma_m), 1 / (sigma_m * sigma_m), 1 / variance_rad2)
                    .asDiagonal()});
  }

  PoseGraph graph_;
};

TEST_F(KnownNodes, AreReachedOnThePathThatLeavesLeastOpen)
{
  const auto known = graph_.known(0);
  ASSERT_EQ(known.size(), 4U);
  const std::vector<std::size_t> order{0, 1, 2, 3};
  for (std::size_t i = 0; i < order.size(); ++i) EXPECT_EQ(known[i].node, order[i]);
  EXPECT_TRUE(known[0].covariance.isZero());
  const Eigen::Matrix3d& toThree = known[3].covariance;
  EXPECT_NEAR(toThree(2, 2), 3 * std::pow(degToRad(0.1), 2), 1e-9);
  EXPECT_NEAR(toThree(0, 0), 3e-4, 5e-5) << "by way of 1 and 2, and not by the short cut";
}

// What a heading of 0.1 degrees moves 2 m away adds to the 1 cm of each link across the way.
TEST_F(KnownNodes, AHeadingThatIsOpenMovesWhatComesAfterIt)
{
  const Eigen::Matrix3d toTwo = graph_.known(0)[2].covariance;
  EXPECT_NEAR(toTwo(0, 0), 2e-4, 1e-9);
  EXPECT_NEAR(toTwo(1, 1), 2e-4 + std::pow(2 * degToRad(0.1), 2), 1e-9);
}

// Seen from 2, the heading of the link to 1 moves 0, 4 m away, and that of the next one by its 2 m.
TEST_F(KnownNodes, AreKnownTheOtherWayAsWell)
{
  for (const PoseGraph::KnownNode& known : graph_.known(2))
  {
    if (known.node != 0) continue;
    EXPECT_NEAR(known.covariance(0, 0), 2e-4, 1e-9);
    EXPECT_NEAR(known.covariance(1, 1), 2e-4 + (16 + 4) * std::pow(degToRad(0.1), 2), 1e-9);
  }
}

TEST_F(KnownNodes, WhatLeavesMoreOpenIsLeftOut)
{
  const double ofALink_m = leftOpen_m(
      Eigen::Vector3d(1e-4, 1e-4, std::pow(degToRad(0.1), 2)).asDiagonal().toDenseMatrix());
  EXPECT_EQ(graph_.known(0, 1.1 * ofALink_m).size(), 2U);
  EXPECT_EQ(graph_.known(0, 1.5 * ofALink_m).size(), 3U);
  EXPECT_EQ(graph_.known(4).size(), 1U);
}

// The link from 2 to 3 says 1 m more than the poses do: it counts for little, and so does the path.
TEST_F(KnownNodes, ALinkThatContradictsThePosesKnowsLittle)
{
  PoseGraph graph;
  graph.add(Pose2{});
  graph.add(Pose2{1, 0, 0});
  const Eigen::Matrix3d information = Eigen::Vector3d(1e4, 1e4, 1e5).asDiagonal();
  graph.add({0, 1, {2, 0, 0}, information});
  EXPECT_GT(graph.known(0)[1].covariance(0, 0), 100 * 1e-4);
}

TEST_F(KnownNodes, ALinkThatLeavesADirectionOpenLeavesItOpen)
{
  PoseGraph graph;
  graph.add(Pose2{});
  graph.add(Pose2{1, 0, 0});
  graph.add({0, 1, {1, 0, 0}, Eigen::Vector3d(0, 1e4, 1e5).asDiagonal()});
  const Eigen::Matrix3d covariance = graph.known(0)[1].covariance;
  EXPECT_GT(covariance(0, 0), 1e3);
  EXPECT_NEAR(covariance(1, 1), 1e-4, 1e-6);
}
}  // namespace psmks
