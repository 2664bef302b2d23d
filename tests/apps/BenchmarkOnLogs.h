/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <gtest/gtest.h>
#include <psmks/eval/Trajectory.h>
#include <tests/support/ProgramTest.h>
#include <tests/unit/logs/RoomLog.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

namespace psmks::test
{
/** Tests of psmks-benchmark on logs of a room, in a scratch folder. */
class BenchmarkOnLogs : public ProgramTest
{
 protected:
  BenchmarkOnLogs() : ProgramTest(PSMKS_PROGRAM) {}

  static constexpr int kScans = 8;

  void SetUp() override { writeGzipped(asFrames(log_), log("room")); }

  std::string log(const std::string& name) const { return path(name + ".rawlog"); }

  ProgramRun run(const std::string& arguments) const
  {
    return ProgramTest::run(arguments + " --json " + path("t.json"));
  }

  nlohmann::json table(std::size_t index = 0) const
  {
    return nlohmann::json::parse(fileText(path("t.json"))).at("tables").at(index);
  }

  nlohmann::json rows(std::size_t index = 0) const { return table(index).at("rows"); }

  void expectUsageError(const std::string& arguments, const std::string& sentence) const
  {
    const ProgramRun done = run(arguments);
    EXPECT_EQ(done.exitCode, 1) << arguments;
    EXPECT_NE(done.errors.find(sentence), std::string::npos) << done.errors;
  }

  /** Writes the true trajectory.
   *  @param sideways_m error of the last pose */
  void writeTruth(const std::string& name, double sideways_m = 0) const
  {
    Trajectory truth;
    for (const auto& step : log_.steps) truth.push_back({step.stamp_s, step.T_world_robot});
    truth.back().pose.y_m += sideways_m;
    std::ofstream out(path(name));
    writeTum(out, truth);
  }

  const RoomLog log_{kScans};
};
}  // namespace psmks::test
