/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/eval/Trajectory.h>
#include <tests/support/ProgramTest.h>
#include <tests/support/Says.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>

namespace psmks
{
namespace
{
using Json = nlohmann::json;
using test::says;

/** The file "truth.tum" has a path of ten metres along x and ten metres to the left, with a pose
 * for each metre and second.
 *
 *                         ^
 *                         |
 *      o--o--o-- ... -->--'        */
class PsmksEvaluate : public test::ProgramTest
{
 protected:
  PsmksEvaluate() : ProgramTest(PSMKS_PROGRAM) {}

  void SetUp() override
  {
    for (int i = 0; i <= 20; ++i)
      truth_.push_back(
          {kStart_s + i, i < 10 ? Pose2{i * 1.0, 0, 0} : Pose2{10, i - 10.0, kPi / 2}});
    write("truth.tum", truth_);
  }

  void write(const std::string& name, const Trajectory& trajectory) const
  {
    std::filesystem::create_directories(std::filesystem::path(path(name)).parent_path());
    std::ofstream file(path(name));
    writeTum(file, trajectory);
  }

  void writeText(const std::string& name, const std::string& text) const
  {
    std::ofstream(path(name)) << text;
  }

  /** Writes the true path in another frame, with the poses from number 10 on displaced by 0.5 m. */
  void writeEstimate(const std::string& name = "estimate.tum") const
  {
    Trajectory estimate = truth_;
    for (std::size_t i = 10; i < estimate.size(); ++i) estimate[i].pose.x_m += 0.5;
    for (auto& [stamp_s, pose] : estimate) pose = Pose2{-4, 2, 1} * pose;
    write(name, estimate);
  }

  /** A row of the JSON file that a run has written. */
  Json rowOf(const std::string& table, std::size_t row = 0) const
  {
    const Json document = Json::parse(fileText(path("errors.json")));
    for (const Json& t : document.at("tables"))
      if (t.at("table") == table) return t.at("rows").at(row);
    ADD_FAILURE() << "no table " << table;
    return {};
  }

  static constexpr double kStart_s = 1.6e9;
  Trajectory truth_;
};

TEST_F(PsmksEvaluate, HoldsATrajectoryAgainstItsGroundTruth)
{
  writeEstimate();
  const auto result = run(
      "--estimate estimate.tum --ground-truth truth.tum --json errors.json --drift_lengths_m 5");
  ASSERT_EQ(result.exitCode, 0) << result.errors;
  EXPECT_EQ(result.errors, "");
  EXPECT_TRUE(says(result.output, {"estimate: 21 poses, 21 with a true one, along 20.0 m",
                                   "poses, first laid over", "poses, aligned", "steps"}));

  const Json first = rowOf("poses, first laid over");
  EXPECT_EQ(first["count"], 21);
  EXPECT_NEAR(first["max_m"].get<double>(), 0.5, 1e-6);
  EXPECT_NEAR(first["mean_m"].get<double>(), 0.5 * 11 / 21, 1e-6);
  EXPECT_NEAR(first["within_percent"].get<double>(), 100.0 * 10 / 21, 1e-4);
  EXPECT_LT(rowOf("poses, aligned")["rms_m"], first["rms_m"]);

  const Json steps = rowOf("steps");
  EXPECT_EQ(steps["count"], 20);
  EXPECT_NEAR(steps["max_m"].get<double>(), 0.5, 1e-6);
  EXPECT_NEAR(steps["median_m"].get<double>(), 0, 1e-6);
  EXPECT_NEAR(rowOf("over 5 m")["max_m"].get<double>(), 0.5, 1e-6);
  EXPECT_TRUE(first["mean_squared_m2"].is_null()) << "published of relations only";
}

TEST_F(PsmksEvaluate, AGroundTruthWithoutHeadingsTellsErrorsOfPositionsAlone)
{
  writeEstimate();
  std::ofstream file(path("station.tum"));
  file << "nan nan nan nan nan nan nan nan\n" << std::fixed;
  for (const auto& [stamp_s, pose] : truth_)
    file << stamp_s << ' ' << pose.x_m << ' ' << pose.y_m << " 0 0 0 0 0\n";
  file.close();
  const auto result = run("-e estimate.tum -g station.tum --json errors.json --plot errors.svg");
  if (hasGnuplot())
  {
    EXPECT_EQ(result.exitCode, 0) << result.errors;
  }
  EXPECT_TRUE(says(result.errors, {"psmks-evaluate: ground truth 'station.tum': 1 of 22 rows has "
                                   "no position",
                                   "21 of 22 rows have no heading"}))
      << result.errors;
  const Json first = rowOf("poses, aligned");
  EXPECT_EQ(first["count"], 21);
  EXPECT_LT(first["max_m"], 0.5);
  EXPECT_TRUE(first["mean_deg"].is_null());
  EXPECT_EQ(rowOf("steps")["count"], 0);
}

TEST_F(PsmksEvaluate, HoldsATrajectoryAgainstRelations)
{
  writeEstimate();
  writeText("drive.relations",
            "# from to x y z roll pitch yaw\n"
            "1600000000 1600000002 2 0 0 0 0 0\n"
            "1600000008 1600000011 2 1 0 0 0 1.5707963\n"
            "1600000000 1600000020 10 10 0 0 0 1.5707963\n"
            "1500000000 1600000020 10 10 0 0 0 1.5707963\n");
  const auto result =
      run("--estimate estimate.tum --relations drive.relations --json errors.json --within_m 0.6");
  ASSERT_EQ(result.exitCode, 0) << result.errors;
  EXPECT_TRUE(says(result.output, {"21 poses, 3 of 4 relations"}));
  const Json all = rowOf("relations");
  EXPECT_EQ(all["count"], 3);
  EXPECT_NEAR(all["mean_m"].get<double>(), 1.0 / 3, 1e-6);
  EXPECT_NEAR(all["mean_squared_m2"].get<double>(), 0.5 / 3, 1e-6);
  EXPECT_NEAR(all["within_percent"].get<double>(), 100, 1e-6);
  EXPECT_EQ(rowOf("relations < 5 s")["count"], 2);
  EXPECT_NEAR(rowOf("relations >= 5 s")["mean_m"].get<double>(), 0.5, 1e-6);
}

TEST_F(PsmksEvaluate, ComparesTrajectoriesInOneTable)
{
  writeEstimate("psmks/trajectory.tum");
  write("exact/trajectory.tum", truth_);
  writeText("drive.relations", "1600000000 1600000002 2 0 0 0 0 0\n");
  const auto result =
      run("-e psmks/trajectory.tum exact/trajectory.tum -g truth.tum -r drive.relations"
          " --csv errors.csv --markdown errors.md --json errors.json");
  ASSERT_EQ(result.exitCode, 0) << result.errors;
  EXPECT_EQ(rowOf("poses, aligned", 0)["estimate"], "psmks");
  EXPECT_EQ(rowOf("poses, aligned", 1)["estimate"], "exact");
  EXPECT_NEAR(rowOf("poses, aligned", 1)["max_m"].get<double>(), 0, 1e-6);
  EXPECT_TRUE(says(fileText(path("errors.csv")), {"estimate,count,within_percent,mean_m",
                                                  "steps,exact,20,", "relations,psmks,"}));
  EXPECT_TRUE(says(fileText(path("errors.md")), {"### steps", "| exact"}));
}

TEST_F(PsmksEvaluate, FirstPosesCanBeLeftOut)
{
  Trajectory estimate = truth_;
  estimate[0].pose = {0, 0, 0.5};  // laying the first pose over the truth then spoils all others
  write("estimate.tum", estimate);
  ASSERT_EQ(run("-e estimate.tum -g truth.tum --skip_poses 1 --json errors.json").exitCode, 0);
  EXPECT_NEAR(rowOf("poses, first laid over")["max_m"].get<double>(), 0, 1e-6);
  expectError(run("-e estimate.tum -g truth.tum --skip_poses 21"), 3, {"21 poses", "skipped"});
}

TEST_F(PsmksEvaluate, ReadsTheGroundTruthsOfMrptAndCarmen)
{
  writeEstimate();
  writeText("drive.GT.txt", "% Timestamp x y phi\n1600000000 0 0 0\n1600000001 1 0 0\n");
  const auto result = run("-e estimate.tum -g drive.GT.txt");
  EXPECT_EQ(result.exitCode, 0) << result.errors;
  EXPECT_TRUE(says(result.output, {"21 poses, 2 with a true one"}));
}

TEST_F(PsmksEvaluate, TakesAGroundTruthWithNumberedRows)
{
  write("estimate.tum", truth_);
  std::string rows;
  for (std::size_t i = 1; i < truth_.size(); ++i)
    rows += std::to_string(i - 1) + ' ' + std::to_string(truth_[i].pose.x_m) + ' ' +
            std::to_string(truth_[i].pose.y_m) + ' ' + std::to_string(truth_[i].pose.phi_rad) +
            '\n';
  writeText("drive_GT.txt", rows);
  ASSERT_EQ(run("-e estimate.tum -g drive_GT.txt --json errors.json").exitCode, 0);
  EXPECT_EQ(rowOf("steps")["count"], 19);
  EXPECT_NEAR(rowOf("steps")["max_m"].get<double>(), 0, 1e-5);

  writeText("short_GT.txt", "0 0 0 0\n1 1 0 0\n");
  expectError(run("-e estimate.tum -g short_GT.txt"), 3, {"numbers of its 2 rows", "21"});
}

TEST_F(PsmksEvaluate, StampsOfAnEstimateMayGoBackwards)
{
  Trajectory estimate = truth_;
  std::swap(estimate[5], estimate[6]);
  write("estimate.tum", estimate);
  ASSERT_EQ(run("-e estimate.tum -g truth.tum --json errors.json").exitCode, 0);
  EXPECT_EQ(rowOf("poses, aligned")["count"], 21);
  EXPECT_NEAR(rowOf("steps")["max_m"].get<double>(), 0, 1e-6);
  expectError(run("-e estimate.tum -g estimate.tum"), 2, {"ground truth", "estimate.tum:7"});
}

TEST_F(PsmksEvaluate, DrawsPathsAndErrors)
{
  writeEstimate("it's \"odd\".tum");
  writeText("drive.relations", "1600000000 1600000002 2 0 0 0 0 0\n");
  const std::string estimate = "-e \"it's \\\"odd\\\".tum\" ";
  ASSERT_EQ(run(estimate + "-g truth.tum -r drive.relations --plot errors.svg").exitCode, 0);
  EXPECT_TRUE(says(fileText(path("errors.svg")), {"<svg", "x, m", "true path, m", "error, deg",
                                                  "time spanned, s", "ground truth", "odd"}));
  ASSERT_EQ(run(estimate + "-r drive.relations --plot errors.png").exitCode, 0);
  EXPECT_EQ(fileText(path("errors.png")).substr(1, 3), "PNG");
}

TEST_F(PsmksEvaluate, FilesThatAreMissingOrDamagedAreNamed)
{
  writeEstimate();
  expectError(run("-e none.tum -g truth.tum"), 2, {"estimate none.tum", "no such file"});
  expectError(run("-e estimate.tum -g none.tum"), 2, {"ground truth none.tum", "no such file"});
  expectError(run("-e estimate.tum -r none"), 2, {"relations none", "no such file"});
  writeText("damaged.tum", "0 0 0 0\n1 0 0 zero\n");
  expectError(run("-e damaged.tum -g truth.tum"), 2, {"damaged.tum:2", "expected"});
  expectError(run("-e estimate.tum -r truth.tum"), 3, {"no relation", "estimate.tum"});
  expectError(run("-e . -g truth.tum"), 2, {"not to be read"});
}

TEST_F(PsmksEvaluate, TellsWhereThereIsNothingInCommon)
{
  writeEstimate();
  writeText("later.tum", "1 0 0 0\n2 0 0 0\n");
  expectError(run("-e later.tum -g truth.tum"), 3, {"no pose at the time of any of later.tum"});
  writeText("later.relations", "1 2 0 0 0 0 0 0\n");
  expectError(run("-e estimate.tum -r later.relations"), 3, {"no relation", "estimate.tum"});
}

TEST_F(PsmksEvaluate, RefusesWhatItDoesNotUnderstand)
{
  writeEstimate();
  expectError(run("-e estimate.tum"), 1, {"--ground-truth or --relations"});
  expectError(run("-g truth.tum"), 1, {"--estimate"});
  expectError(run("-e estimate.tum -g truth.tum --plot errors.pdf"), 1, {"errors.pdf", ".svg"});
  expectError(run("-e estimate.tum -g truth.tum --within_m -1"), 1, {"--within_m"});
  expectError(run("-e estimate.tum -g truth.tum --csv none/errors.csv"), 1,
              {"--csv", "none/errors.csv"});
  expectError(run("-e estimate.tum -g truth.tum --plot none/errors.png"), 1, {"none/errors.png"});
}

TEST_F(PsmksEvaluate, ExplainsItself)
{
  const auto help = run("--help");
  EXPECT_EQ(help.exitCode, 0);
  EXPECT_TRUE(says(help.output, {"--estimate", "--relations", "Examples:", "Exit codes:"}));
  EXPECT_TRUE(says(run("--version").output, {"psmks-evaluate "}));
}

TEST_F(PsmksEvaluate, ReadsMrptsUwbDemo)
{
  const std::string file = "/usr/share/mrpt/datasets/uwb_ro-localization_demo_GT.txt";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not installed";
  Trajectory estimate = readTrajectory(file);
  estimate.insert(estimate.begin(), StampedPose{0, {}});  // a scan before the first action
  for (auto& [stamp_s, pose] : estimate) stamp_s += kStart_s;
  write("estimate.tum", estimate);
  const auto result = run("-e estimate.tum -g " + file + " --json errors.json");
  ASSERT_EQ(result.exitCode, 0) << result.errors;
  EXPECT_EQ(rowOf("steps")["count"], 341);
  EXPECT_NEAR(rowOf("poses, first laid over")["max_m"].get<double>(), 0, 1e-6);
}
}  // namespace
}  // namespace psmks
