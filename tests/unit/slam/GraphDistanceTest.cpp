/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/slam/GraphDistance.h>

#include <cmath>

namespace psmks
{
namespace
{
void tie(PoseGraph& graph, std::size_t from, std::size_t to, double length_m)
{
  graph.add({from, to, {length_m, 0, 0}, Eigen::Matrix3d::Identity()});
}
}  // namespace

//     0 --2-- 1 --2-- 2      the way to 3 is 3 over the short cut, not 6 round the corner;
//      \              |      nothing leads to 4
//       '----3---- 3 -2'   4
TEST(GraphDistance, IsThatOfTheShortestWayEitherWayAlongLinks)
{
  PoseGraph graph;
  for (int node = 0; node < 5; ++node) graph.add(Pose2());
  tie(graph, 0, 1, 2);
  tie(graph, 1, 2, 2);
  tie(graph, 2, 3, 2);
  tie(graph, 3, 0, 3);
  const std::vector<double> fromFirst_m = graphDistances_m(graph, 0);
  ASSERT_EQ(fromFirst_m.size(), 5U);
  for (const auto& [node, expected_m] : {std::pair{0, 0.0}, {1, 2.0}, {2, 4.0}, {3, 3.0}})
    EXPECT_NEAR(fromFirst_m[static_cast<std::size_t>(node)], expected_m, 1e-12);
  EXPECT_TRUE(std::isinf(fromFirst_m[4]));
  EXPECT_NEAR(graphDistances_m(graph, 3)[2], 2, 1e-12);
}
}  // namespace psmks
