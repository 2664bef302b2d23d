/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <mrpt/graphs/CNetworkOfPoses.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <psmks/eval/Trajectory.h>
#include <tests/support/PoseMatcher.h>
#include <tests/support/ProgramTest.h>
#include <tests/support/Says.h>
#include <tests/unit/logs/RoomLog.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

namespace psmks
{
namespace
{
using namespace test;
using Names = std::set<std::string>;

const Names kAllFiles{"trajectory.tum", "odometry.tum",  "matches.csv",  "graph.g2o",
                      "map.pgm",        "map.yaml",      "map.png",      "map.svg",
                      "map.3Dscene",    "map.simplemap", "segments.csv", "summary.json"};

/** What the files of psmks-slam hold, read as other programs read them. */
class PsmksSlamOutputs : public test::ProgramTest
{
 protected:
  PsmksSlamOutputs() : ProgramTest(PSMKS_PROGRAM) {}

  void SetUp() override { test::writeGzipped(test::asFrames(log_), path("room.rawlog")); }

  ProgramRun slam(const std::string& flags = "") const
  {
    return run("room.rawlog -o out -w --set reference.map_spacing_m=0.15 " + flags);
  }

  Names written() const
  {
    Names names;
    for (const auto& entry : std::filesystem::directory_iterator(path("out")))
      names.insert(entry.path().filename().string());
    return names;
  }

  nlohmann::json summary() const
  {
    return nlohmann::json::parse(fileText(path("out/summary.json")));
  }

  static constexpr int kScans = 8;
  const test::RoomLog log_{kScans};
};

/** A binary PGM. */
struct Picture
{
  explicit Picture(const std::string& text)
  {
    std::istringstream in(text);
    std::string kind;
    int most = 0;
    in >> kind >> width >> height >> most;
    EXPECT_EQ(kind, "P5");
    EXPECT_EQ(most, 255);
    in.get();
    pixels.assign(std::istreambuf_iterator<char>(in), {});
  }

  int at(int column, int rowFromBelow) const
  {
    const int index = (height - 1 - rowFromBelow) * width + column;
    return static_cast<unsigned char>(pixels[static_cast<std::size_t>(index)]);
  }

  int width = 0, height = 0;
  std::string pixels;
};
}  // namespace

TEST_F(PsmksSlamOutputs, AllAreWrittenUnlessSomeAreChosen)
{
  ASSERT_EQ(slam().exitCode, 0);
  EXPECT_EQ(written(), kAllFiles);
  std::filesystem::remove_all(path("out"));
  ASSERT_EQ(slam("--outputs grid,trajectory").exitCode, 0);
  EXPECT_EQ(written(),
            Names({"map.pgm", "map.yaml", "trajectory.tum", "odometry.tum", "summary.json"}));
}

TEST_F(PsmksSlamOutputs, ThePictureCanBeLeftOut)
{
  ASSERT_EQ(slam("--no-picture").exitCode, 0);
  Names expected = kAllFiles;
  expected.erase("map.png");
  EXPECT_EQ(written(), expected);
}

TEST_F(PsmksSlamOutputs, AnUnknownOneIsAWrongUse)
{
  expectError(slam("--outputs grid,costmap"), 1, {"costmap", "trajectory", "simplemap"});
}

TEST_F(PsmksSlamOutputs, MrptReadsTheGridWithEveryCellInItsClass)
{
  ASSERT_EQ(slam().exitCode, 0);
  const Picture picture(fileText(path("out/map.pgm")));
  const auto grid = mrpt::maps::COccupancyGridMap2D::FromROSMapServerYAML(path("out/map.yaml"));
  ASSERT_EQ(static_cast<int>(grid.getSizeX()), picture.width);
  ASSERT_EQ(static_cast<int>(grid.getSizeY()), picture.height);
  ASSERT_EQ(picture.pixels.size(), static_cast<std::size_t>(picture.width * picture.height));
  int wrong = 0, walls = 0;
  for (int row = 0; row < picture.height; ++row)
    for (int column = 0; column < picture.width; ++column)
    {
      const int pixel = picture.at(column, row);
      const float isFree = grid.getCell(column, row);
      wrong += (pixel == 254) != (isFree > 0.9f) || (pixel == 0) != (isFree < 0.1f) ||
               (pixel == 128) != (isFree == 0.5f);
      walls += pixel == 0;
    }
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(walls, 100);
}

TEST_F(PsmksSlamOutputs, TheGridIsFreeAheadOfTheRobot)
{
  ASSERT_EQ(slam().exitCode, 0);
  const auto grid = mrpt::maps::COccupancyGridMap2D::FromROSMapServerYAML(path("out/map.yaml"));
  for (const auto& step : log_.steps)
  {
    const Eigen::Vector2d ahead_m = step.T_world_robot * Eigen::Vector2d(1, 0);
    EXPECT_GT(grid.getPos(static_cast<float>(ahead_m.x()), static_cast<float>(ahead_m.y())), 0.9f);
  }
}

TEST_F(PsmksSlamOutputs, MrptReadsTheGraphOfTheKeyframes)
{
  ASSERT_EQ(slam("--save-g2o room.g2o").exitCode, 0);
  EXPECT_EQ(fileText(path("room.g2o")), fileText(path("out/graph.g2o")));
  mrpt::graphs::CNetworkOfPoses2DInf graph;
  graph.loadFromTextFile(path("room.g2o"));
  EXPECT_EQ(graph.nodes.size(), summary()["references"].get<std::size_t>());
  EXPECT_GE(graph.edgeCount(), graph.nodeCount() - 1);
  const Trajectory trajectory = readTrajectory(path("out/trajectory.tum"));
  for (const auto& [scan, pose] : graph.nodes)
    EXPECT_TRUE(isNearly({pose.x(), pose.y(), pose.phi()}, trajectory.at(scan).pose, 1e-5, 1e-5));
  for (const auto& [ends, edge] : graph.edges)
  {
    const auto seen = graph.nodes[ends.second] - graph.nodes[ends.first];
    EXPECT_TRUE(isNearly({edge.mean.x(), edge.mean.y(), edge.mean.phi()},
                         {seen.x(), seen.y(), seen.phi()}, 2e-3, degToRad(0.05)));
    EXPECT_GT(edge.cov_inv(0, 0), 1e4) << "a link of centimetres";
  }
}

TEST_F(PsmksSlamOutputs, AGraphIsNotReplacedUnasked)
{
  std::ofstream(path("room.g2o")) << "precious\n";
  expectError(run("room.rawlog -o out --save-g2o room.g2o"), 1, {"room.g2o", "--overwrite"});
}

TEST_F(PsmksSlamOutputs, TheDrawingHasItsTextsAsTexts)
{
  ASSERT_EQ(run("room.rawlog -o out").exitCode, 0);
  const std::string svg = fileText(path("out/map.svg"));
  EXPECT_TRUE(says(svg, {"<svg", "room.rawlog, matcher psmks</text>", "id=\"segments\" d=\"M",
                         "id=\"path\"", ">x, m</text>", "</svg>"}));
}

TEST_F(PsmksSlamOutputs, TheOptionsInTheSummaryAreNumbersAndTruths)
{
  ASSERT_EQ(slam("--outputs matches").exitCode, 0);
  const auto options = summary()["options"];
  EXPECT_DOUBLE_EQ(options["reference"]["map_spacing_m"].get<double>(), 0.15);
  EXPECT_EQ(options["matcher"]["scheme"], "joint");
}
}  // namespace psmks
