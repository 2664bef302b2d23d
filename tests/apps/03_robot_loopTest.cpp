/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/geometry/Angle.h>
#include <tests/support/Program.h>

#include <cmath>
#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

namespace psmks
{
namespace
{
struct PrintedPose
{
  double time_s = 0, x_m = 0, y_m = 0, phi_deg = 0, sigma_mm = 0;
  std::string source, status;
};

/** The lines that the example prints after the scans, without that of the wheels. */
std::vector<PrintedPose> printedPoses(const std::string& output)
{
  std::vector<PrintedPose> poses;
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);)
  {
    PrintedPose pose;
    char source[20], status[20];
    const int fields = std::sscanf(
        line.c_str(), "%lf s %19s %19s x %lf m y %lf m phi %lf deg sigma of x %lf mm", &pose.time_s,
        source, status, &pose.x_m, &pose.y_m, &pose.phi_deg, &pose.sigma_mm);
    if (fields != 7) continue;
    pose.source = source;
    pose.status = status;
    poses.push_back(pose);
  }
  return poses;
}

// Chords of 0.2 m, each 10 degrees further: after k of them the robot has turned by 10 k degrees
// and stands where the sum of the chords leads.
TEST(ExampleRobotLoop, FollowsTheCircleByTheScans)
{
  const ProgramRun run = runProgram("'" PSMKS_PROGRAM "'");
  EXPECT_EQ(run.exitCode, 0) << run.errors;
  const auto poses = printedPoses(run.output);
  ASSERT_EQ(poses.size(), 10u) << run.output;
  double x_m = 0, y_m = 0;
  for (int second = 0; second <= 36; ++second)
  {
    if (second % 4 == 0)
    {
      const PrintedPose& pose = poses[static_cast<std::size_t>(second / 4)];
      EXPECT_EQ(pose.time_s, second);
      EXPECT_NEAR(pose.x_m, x_m, 0.005);
      EXPECT_NEAR(pose.y_m, y_m, 0.005);
      EXPECT_NEAR(wrapAngle(degToRad(pose.phi_deg - 10 * second)), 0, degToRad(0.1));
      EXPECT_EQ(pose.source, second == 0 ? "FirstScan" : "Match");
      EXPECT_EQ(pose.status, second == 0 ? "NotRun" : "Converged");
      EXPECT_EQ(pose.sigma_mm > 0, second > 0);
    }
    x_m += 0.2 * std::cos(degToRad(10 * second));
    y_m += 0.2 * std::sin(degToRad(10 * second));
  }
}

TEST(ExampleRobotLoop, TellsThatTheWheelsAloneDoNotCloseTheCircle)
{
  const ProgramRun run = runProgram("'" PSMKS_PROGRAM "'");
  const auto line = run.output.find("the wheels alone:");
  ASSERT_NE(line, std::string::npos) << run.output;
  double x_m = 0, y_m = 0, phi_deg = 0;
  ASSERT_EQ(std::sscanf(run.output.c_str() + line, "the wheels alone: x %lf m y %lf m phi %lf deg",
                        &x_m, &y_m, &phi_deg),
            3);
  EXPECT_GT(std::hypot(x_m, y_m), 0.5);
  EXPECT_NEAR(phi_deg, 36 * 9 - 360, 0.001);
}
}  // namespace
}  // namespace psmks
