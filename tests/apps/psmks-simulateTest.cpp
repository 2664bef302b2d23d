/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/serialization/CArchive.h>
#include <psmks/eval/Trajectory.h>
#include <psmks/logs/RawlogReader.h>
#include <psmks/mrpt/Convert.h>
#include <psmks/sim/Worlds.h>
#include <tests/support/PoseMatcher.h>
#include <tests/support/ProgramTest.h>

#include <filesystem>
#include <fstream>

namespace psmks
{
namespace
{
constexpr int kScans = 31;  // in 0.05 minutes at 10 scans a second, both ends included
const char* const kResults[] = {"drive.rawlog", "drive.gt.tum", "drive.GT.txt", "drive.world.png"};

class PsmksSimulate : public test::ProgramTest
{
 protected:
  PsmksSimulate() : ProgramTest(PSMKS_PROGRAM) {}

  /** Simulates three seconds to the files drive.*. */
  ProgramRun drive(const std::string& flags) const
  {
    return run("--minutes 0.05 --output drive.rawlog --overwrite " + flags);
  }

  std::vector<LaserFrame> frames() const
  {
    RawlogReader reader(path("drive.rawlog"));
    std::vector<LaserFrame> all;
    for (LaserFrame frame; reader.next(frame);) all.push_back(frame);
    EXPECT_EQ(reader.damage(), "");
    return all;
  }

  Trajectory truth() const { return readTrajectory(path("drive.gt.tum")); }

  /** Writes a grid map of a hall of 10 x 6 m about the origin with solid walls, in cells of 10 cm.
   */
  void writeGridmap(const std::string& name) const
  {
    mrpt::maps::COccupancyGridMap2D map(-5, 5, -3, 3, 0.1f);
    map.fill(0);
    for (int column = 1; column < 99; ++column)
      for (int row = 1; row < 59; ++row) map.setCell(column, row, 1);
    mrpt::io::CFileGZOutputStream file(path(name));
    mrpt::serialization::archiveFrom(file) << map;
  }
};

TEST_F(PsmksSimulate, WritesAllItsFilesAndASummary)
{
  const ProgramRun run = drive("--world room");
  ASSERT_EQ(run.exitCode, 0) << run.errors;
  EXPECT_EQ(run.errors, "");
  for (const char* name : kResults) EXPECT_GT(std::filesystem::file_size(path(name)), 100u) << name;
  for (const char* part : {"room: 32 walls, 0 points, 0 people", "31 of 181 rays in 3.0 s",
                           "driven ", "collisions       0", "us a scan", "drive.world.png"})
    EXPECT_NE(run.output.find(part), std::string::npos) << part << " in\n" << run.output;
}

TEST_F(PsmksSimulate, TheGroundTruthHasAPoseForEveryScanInBothFiles)
{
  drive("--world room");
  const auto scans = frames();
  const Trajectory tum = truth(), mrpt = readTrajectory(path("drive.GT.txt"));
  ASSERT_EQ(scans.size(), static_cast<std::size_t>(kScans));
  ASSERT_EQ(tum.size(), scans.size());
  ASSERT_EQ(mrpt.size(), scans.size());
  for (std::size_t i = 0; i < scans.size(); ++i)
  {
    EXPECT_EQ(tum[i].stamp_s, scans[i].stamp_s);
    EXPECT_EQ(mrpt[i].stamp_s, scans[i].stamp_s);
    EXPECT_TRUE(isNearly(tum[i].pose, mrpt[i].pose, 1e-8, 1e-8));
  }
}

/** From the true poses, all points of the scans lie on walls of the room. */
TEST_F(PsmksSimulate, TheScansShowTheWorldFromTheTruePoses)
{
  drive("--world room --rays 91 --range_sigma_m 0.001 --laser_x_m 0.2 --laser_phi_deg 30");
  const World world = makeSite("room", 1).world;
  const auto scans = frames();
  const Trajectory poses = truth();
  ASSERT_EQ(poses.size(), scans.size());
  for (std::size_t i = 0; i < scans.size(); ++i)
  {
    const Scan scan = ScanConverter().convert(*scans[i].scan);
    const Pose2 T_robot_sensor = sensorMounting(*scans[i].scan).T_robot_sensor;
    ASSERT_TRUE(isNearly(T_robot_sensor, {0.2, 0, degToRad(30)}, 1e-6, 1e-6));
    for (int ray = 0; ray < scan.grid.count(); ++ray)
    {
      const double range_m = scan.range_m[static_cast<std::size_t>(ray)];
      const Eigen::Vector2d point_m =
          poses[i].pose * T_robot_sensor * Eigen::Vector2d(range_m * scan.grid.direction(ray));
      ASSERT_LT(world.clearance_m(point_m, 1, 0), 0.006) << "scan " << i << ", ray " << ray;
    }
  }
}

TEST_F(PsmksSimulate, BothFormatsHoldTheSameDrive)
{
  drive("--world room --format actions");
  const auto actions = frames();
  drive("--world room --format observations");
  const auto observations = frames();
  ASSERT_EQ(actions.size(), observations.size());
  for (std::size_t i = 1; i < actions.size(); ++i)
  {
    EXPECT_EQ(actions[i].scan->getScanRange(90), observations[i].scan->getScanRange(90));
    EXPECT_TRUE(isNearly(*actions[i].odometry, *observations[i].odometry, 1e-9, 1e-9));
  }
}

TEST_F(PsmksSimulate, TheSameSeedGivesTheSameBytesAndAnotherDoesNot)
{
  const auto files = [this](const std::string& seed)
  {
    EXPECT_EQ(drive("--world clutter --people 2 --sweep_s 0.05 --seed " + seed).exitCode, 0);
    std::vector<std::string> texts;
    for (const char* name : kResults) texts.push_back(fileText(path(name)));
    return texts;
  };
  const auto first = files("3"), again = files("3"), other = files("4");
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    EXPECT_EQ(first[i], again[i]) << kResults[i];
    EXPECT_NE(first[i], other[i]) << kResults[i];
  }
}

TEST_F(PsmksSimulate, TheLasersFlagsReachTheScans)
{
  drive(
      "--world room --rays 360 --fov_deg 360 --max_range_m 8 --range_sigma_m 0.03 "
      "--quantum_m 0.25 --drop_out_share 0.5");
  const auto scans = frames();
  ASSERT_FALSE(scans.empty());
  const Scan scan = ScanConverter().convert(*scans[0].scan);
  EXPECT_EQ(scan.grid.count(), 360);
  EXPECT_TRUE(scan.grid.closed());
  EXPECT_NEAR(scan.maxRange_m, 8, 1e-6);
  EXPECT_NEAR(scan.rangeSigma_m, 0.03, 1e-6);
  int returns = 0;
  for (std::size_t ray = 0; ray < 360; ++ray)
  {
    if (!scan.valid[ray]) continue;
    ++returns;
    EXPECT_NEAR(std::remainder(scan.range_m[ray], 0.25), 0, 1e-5);
  }
  EXPECT_GT(returns, 50);
  EXPECT_LT(returns, 250);
}

TEST_F(PsmksSimulate, ARouteIsDrivenToItsEnd)
{
  std::ofstream(path("short.route")) << "# in the middle of the hall\n-3 0\n-1 0\n-1 1\n";
  writeGridmap("hall.gridmap.gz");
  const ProgramRun run =
      this->run("--world hall.gridmap.gz --route short.route --output drive.rawlog");
  ASSERT_EQ(run.exitCode, 0) << run.errors;
  EXPECT_NE(run.output.find("to the end of the route"), std::string::npos) << run.output;
  EXPECT_TRUE(isNearly(truth().front().pose, {-3, 0, 0}, 1e-6, 1e-6));
  EXPECT_LT((truth().back().pose.translation() - Eigen::Vector2d(-1, 1)).norm(), 0.3);
}

/** The far wall of the hall is 4.9 m from its middle: the face of the outer cells. */
TEST_F(PsmksSimulate, GridmapsAreWorlds)
{
  writeGridmap("hall.gridmap");
  const ProgramRun run =
      drive("--world hall.gridmap --start_x_m 0 --start_y_m 0 --start_phi_deg 0 --people 1");
  ASSERT_EQ(run.exitCode, 0) << run.errors;
  EXPECT_NE(run.output.find("100 x 60 cells of 0.1 m, 1 people"), std::string::npos) << run.output;
  EXPECT_TRUE(isNearly(truth().front().pose, Pose2(), 1e-9, 1e-9));
  drive("--world hall.gridmap --start_x_m 0 --start_y_m 0 --start_phi_deg 0");
  EXPECT_NEAR(frames().front().scan->getScanRange(90), 4.9, 0.05);
}

TEST_F(PsmksSimulate, ImagesAreWorldsWithAResolution)
{
  std::ofstream image(path("hall.pgm"));
  image << "P2\n100 60\n255\n";
  for (int row = 0; row < 60; ++row)
    for (int column = 0; column < 100; ++column)
      image << (row % 59 == 0 || column % 99 == 0 ? "0 " : "255 ");
  image.close();
  EXPECT_EQ(drive("--world hall.pgm --resolution_m 0.1").exitCode, 0);
  expectError(drive("--world hall.pgm"), 1, {"add --resolution_m"});
}

TEST_F(PsmksSimulate, ActivMediaMapsAreWorlds)
{
  std::ofstream(path("box.map"))
      << "2D-Map\nNumLines: 4\nCairn: RobotHome 1000 0 90 \"\" ICON \"\"\n"
         "LINES\n-3000 -2000 3000 -2000\n3000 -2000 3000 2000\n"
         "3000 2000 -3000 2000\n-3000 2000 -3000 -2000\nDATA\n";
  const ProgramRun run = drive("--world box.map");
  ASSERT_EQ(run.exitCode, 0) << run.errors;
  EXPECT_NE(run.output.find("4 walls"), std::string::npos) << run.output;
  EXPECT_TRUE(isNearly(truth().front().pose, {1, 0, degToRad(90)}, 1e-6, 1e-6));
}

TEST_F(PsmksSimulate, ResultsAreNotOverwrittenUnlessAsked)
{
  ASSERT_EQ(run("--world room --minutes 0 --output drive.rawlog").exitCode, 0);
  expectError(run("--world room --minutes 0 --output drive.rawlog"), 1, {"--overwrite"});
  EXPECT_EQ(run("--world room --minutes 0 --output drive.rawlog --overwrite").exitCode, 0);
}

TEST_F(PsmksSimulate, WhatCannotBeAcceptedIsAUsageError)
{
  expectError(run("--world room"), 1, {"--output"});
  expectError(run("--output drive.rawlog"), 1, {"--world"});
  expectError(run("--world room --output drive.log"), 1, {"does not end in .rawlog"});
  expectError(run("--world room --output /absent/drive.rawlog"), 1, {"cannot write"});
  expectError(drive("--world room --driver nobody"), 1, {"--driver"});
  expectError(drive("--world room --driver route"), 1, {"add --route"});
  expectError(drive("--world room --rays 1"), 1, {"--rays"});
  expectError(drive("--world room --sweep_s 0.2"), 1, {"--sweep_s"});
  expectError(drive("--world room --sweep_s 0.05 --interleaved_turns 2"), 1,
              {"--interleaved_turns", "period"});
  expectError(drive("--world room --start_x_m 12"), 1, {"does not fit in"});
}

TEST_F(PsmksSimulate, AMissingOrDamagedWorldIsAnInputError)
{
  expectError(drive("--world nowhere"), 2, {"no world of --list-worlds"});
  std::ofstream(path("foreign.gridmap")) << "something else";
  expectError(drive("--world foreign.gridmap"), 2, {"no MRPT grid map"});
  std::ofstream(path("foreign.map")) << "2D-Map\nLINES\n1 2 three 4\n";
  expectError(drive("--world foreign.map"), 2, {"3"});
  std::ofstream(path("foreign.png")) << "something else";
  expectError(drive("--world foreign.png --resolution_m 0.1"), 2, {"cannot be read as an image"});
  std::ofstream(path("foreign.route")) << "1 2\nthree 4\n";
  expectError(drive("--world room --route foreign.route"), 2, {"2"});
  expectError(drive("--world room --route absent.route"), 2, {"absent.route"});
}

TEST_F(PsmksSimulate, HelpVersionAndTheListOfWorldsEndWell)
{
  EXPECT_EQ(run("--help").exitCode, 0);
  EXPECT_EQ(run("--version").output.rfind("psmks-simulate ", 0), 0u);
  const ProgramRun list = run("--list-worlds");
  EXPECT_EQ(list.exitCode, 0);
  EXPECT_NE(list.output.find("room\n"), std::string::npos);
}
}  // namespace
}  // namespace psmks
