/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <tests/support/ProgramTest.h>
#include <tests/support/Says.h>
#include <tests/unit/logs/RoomLog.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace psmks
{
namespace
{
using test::says;

class PsmksSlamRelations : public test::ProgramTest
{
 protected:
  PsmksSlamRelations() : ProgramTest(PSMKS_PROGRAM) {}

  void SetUp() override { test::writeGzipped(test::asFrames(log_), path("room.rawlog")); }

  ProgramRun slam(const std::string& flags) const { return run("room.rawlog -o out -w " + flags); }

  nlohmann::json summary() const
  {
    return nlohmann::json::parse(fileText(path("out/summary.json")));
  }

  /** Writes the true motions from the first scan to each of the others. */
  void writeRelations() const
  {
    std::ofstream file(path("room.relations"));
    file.precision(16);
    for (const auto& step : log_.steps)
      file << log_.steps.front().stamp_s << ' ' << step.stamp_s << ' ' << step.T_world_robot.x_m
           << ' ' << step.T_world_robot.y_m << " 0 0 0 " << step.T_world_robot.phi_rad << '\n';
  }

  static constexpr int kScans = 8;
  const test::RoomLog log_{kScans};
};

TEST_F(PsmksSlamRelations, TheirErrorsAreReported)
{
  writeRelations();
  const ProgramRun run = slam("--relations room.relations");
  ASSERT_EQ(run.exitCode, 0) << run.errors;
  EXPECT_TRUE(says(run.output, {"relations  ", "spanning < 5 s", "over 8"}));
  const auto errors = summary()["relations_error"];
  EXPECT_EQ(errors["all"]["relations"], kScans);
  EXPECT_EQ(errors["spanning_below_5s"]["relations"], kScans);
  EXPECT_LT(errors["all"]["mean_m"], 2e-3);

  ASSERT_EQ(slam("--relations room.relations --matcher odometry").exitCode, 0);
  EXPECT_GT(summary()["relations_error"]["all"]["mean_deg"], 2);
}

TEST_F(PsmksSlamRelations, WithoutThemNothingIsSaidOfThem)
{
  const ProgramRun run = slam("");
  EXPECT_EQ(run.output.find("relations"), std::string::npos);
  EXPECT_FALSE(summary().contains("relations_error"));
}

TEST_F(PsmksSlamRelations, OfAnotherTimeAreAnInputErrorAfterEverythingIsSaved)
{
  std::ofstream(path("room.relations")) << "1 2 0 0 0 0 0 0\n";
  const ProgramRun run = slam("--relations room.relations");
  EXPECT_EQ(run.exitCode, 2);
  EXPECT_TRUE(says(run.errors, {"psmks-slam: none of the relations 'room.relations'"}));
  EXPECT_EQ(summary()["scans"], kScans);
}

TEST_F(PsmksSlamRelations, ThatCannotBeReadAreAnInputErrorBeforeTheRun)
{
  std::ofstream(path("room.relations")) << "1 2 3\n";
  for (const char* name : {"room.relations", "none.relations"})
  {
    const ProgramRun run = slam(std::string("--relations ") + name);
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_TRUE(says(run.errors, {"psmks-slam: relations ", name}));
    EXPECT_FALSE(std::filesystem::exists(path("out")));
  }
}
}  // namespace
}  // namespace psmks
