/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/slam/G2oFile.h>

#include <Eigen/Cholesky>
#include <map>
#include <sstream>
#include <string>

namespace psmks
{
namespace
{
/** A triangle driven with a drift, whose last link contradicts the others.
 *
 *          2
 *        /   \
 *      0 ----- 1
 */
PoseGraph triangle()
{
  PoseGraph graph;
  graph.add(Pose2{0, 0, 0});
  graph.add(Pose2{4, 0, degToRad(120)});
  graph.add(Pose2{2, 3.5, degToRad(-120)});
  Eigen::Matrix3d information = Eigen::Vector3d(1e4, 4e4, 1e5).asDiagonal();
  information(0, 1) = information(1, 0) = 5e3;
  information(1, 2) = information(2, 1) = 2e4;
  graph.add(PoseLink{0, 1, {4, 0, degToRad(120)}, information});
  graph.add(PoseLink{1, 2, {4, 0.1, degToRad(121)}, information});
  graph.add(PoseLink{0, 2, {2.3, 3.3, degToRad(-118)}, information});
  graph.optimise();
  return graph;
}

/** The poses and the plain sum of squares of a file, as g2o defines them. */
class G2oText
{
 public:
  explicit G2oText(const std::string& text)
  {
    std::istringstream in(text);
    for (std::string kind; in >> kind;)
    {
      if (kind == "VERTEX_SE2")
        readVertex(in);
      else if (kind == "EDGE_SE2")
        readEdge(in);
      else
        ADD_FAILURE() << kind;
    }
  }

  double squares() const
  {
    double sum = 0;
    for (const Edge& edge : edges)
    {
      const Pose2 off = edge.measured.inverse() * poses.at(edge.from).inverse() * poses.at(edge.to);
      const Eigen::Vector3d e(off.x_m, off.y_m, wrapAngle(off.phi_rad));
      sum += e.dot(edge.information * e);
    }
    return sum;
  }

  struct Edge
  {
    std::size_t from, to;
    Pose2 measured;
    Eigen::Matrix3d information;
  };
  std::map<std::size_t, Pose2> poses;
  std::vector<Edge> edges;

 private:
  void readVertex(std::istream& in)
  {
    std::size_t name = 0;
    Pose2 pose;
    in >> name >> pose.x_m >> pose.y_m >> pose.phi_rad;
    poses[name] = pose;
  }

  void readEdge(std::istream& in)
  {
    Edge edge;
    in >> edge.from >> edge.to >> edge.measured.x_m >> edge.measured.y_m >> edge.measured.phi_rad;
    for (Eigen::Index row = 0; row < 3; ++row)
      for (Eigen::Index column = row; column < 3; ++column)
      {
        in >> edge.information(row, column);
        edge.information(column, row) = edge.information(row, column);
      }
    edges.push_back(edge);
  }
};

G2oText written(const PoseGraph& graph, const std::vector<std::size_t>& names = {0, 17, 33})
{
  std::ostringstream out;
  writeG2o(out, graph, names);
  return G2oText(out.str());
}
}  // namespace

TEST(G2oFile, NodesHaveTheNamesAndThePosesThatTheGraphGivesThem)
{
  const PoseGraph graph = triangle();
  const G2oText file = written(graph);
  ASSERT_EQ(file.poses.size(), 3U);
  ASSERT_EQ(file.edges.size(), 3U);
  EXPECT_EQ(file.poses.at(17).x_m, graph.poses()[1].x_m);
  EXPECT_EQ(file.poses.at(33).phi_rad, graph.poses()[2].phi_rad);
  EXPECT_EQ(file.edges[2].from, 0U);
  EXPECT_EQ(file.edges[2].to, 33U);
  EXPECT_EQ(file.edges[1].measured.y_m, 0.1);
}

TEST(G2oFile, ItsSquaresAreTheWeightedOnesOfTheGraph)
{
  const PoseGraph graph = triangle();
  double squares = 0;
  for (const PoseLink& link : graph.links())
  {
    const Eigen::Vector3d e = linkError(link, graph.poses()[link.from], graph.poses()[link.to]);
    squares += graph.weight(link) * e.dot(link.information * e);
  }
  EXPECT_GT(squares, 1) << "the links contradict each other";
  EXPECT_NEAR(written(graph).squares(), squares, 1e-4)
      << "what makes the matrices invertible adds little";
}

TEST(G2oFile, ThePosesOfTheGraphAreAMinimumOfTheSquares)
{
  const G2oText file = written(triangle());
  const double least = file.squares();
  for (const std::size_t name : {17U, 33U})
    for (const double step : {-1e-3, 1e-3})
      for (double Pose2::*coordinate : {&Pose2::x_m, &Pose2::y_m, &Pose2::phi_rad})
      {
        G2oText moved = file;
        moved.poses[name].*coordinate += step;
        EXPECT_GT(moved.squares(), least) << name << ' ' << step;
      }
}

TEST(G2oFile, ALinkThatLeavesADirectionOpenHasAMatrixThatCanBeInverted)
{
  PoseGraph graph;
  graph.add(Pose2{});
  graph.add(Pose2{1, 0, 0});
  graph.add(PoseLink{0, 1, {1, 0, degToRad(30)}, Eigen::Vector3d(0, 1e4, 1e4).asDiagonal()});
  const Eigen::Matrix3d information = written(graph, {0, 1}).edges.at(0).information;
  EXPECT_GT(information.llt().matrixL().toDenseMatrix().diagonal().minCoeff(), 0.9e-2);
}

TEST(G2oFile, AGraphWithoutNodesIsAnEmptyFile)
{
  std::ostringstream out;
  writeG2o(out, PoseGraph(), {});
  EXPECT_EQ(out.str(), "");
}
}  // namespace psmks
