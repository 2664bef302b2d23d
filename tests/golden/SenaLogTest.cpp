/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/eval/OccupiedCells.h>
#include <psmks/logs/OpenLog.h>
#include <psmks/mrpt/Convert.h>
#include <psmks/slam/TrajectoryBuilder.h>

#include <fstream>
#include <ostream>

namespace psmks
{
namespace
{
/** A robot drives once around the corridors of a faculty, 77 m, with a SICK LMS of 361 rays.
 * Debian's package mrpt-common installs the log. */
constexpr const char* kSena =
    "/usr/share/mrpt/datasets/2006-01ENE-21-SENA_Telecom Faculty_one_loop_only.rawlog";

/** The cells of 5 cm that the returns of all scans fill where each stands at its pose: the fewer,
 * the better the poses. */
std::size_t occupiedCells(const std::vector<PosedScan>& scans)
{
  OccupiedCells cells;
  const Pose2 T_first_world = scans.front().T_world_sensor().inverse();
  for (const PosedScan& scan : scans) cells.add(scan.scan, T_first_world * scan.T_world_sensor());
  return cells.count();
}

/** The scans of the log with their poses in the end, by the default options. */
std::vector<PosedScan> posedScans(ReferenceChoice choice)
{
  ReferenceOptions reference;
  reference.choice = choice;
  TrajectoryBuilder builder(makePairMatcher("psmks"), reference, OdometryOptions());
  const auto reader = openLog(kSena);
  ScanConverter converter;
  LaserFrame frame;
  while (reader->next(frame))
  {
    Scan scan = converter.convert(*frame.scan);
    scan.stamp_s = frame.stamp_s;
    builder.add(std::move(scan), sensorMounting(*frame.scan).T_robot_sensor, frame.odometry);
  }
  builder.optimise();
  return builder.scans();
}

struct SenaFigures
{
  const char* name;
  ReferenceChoice choice;
  std::size_t cells;  //!< as measured
};

void PrintTo(const SenaFigures& figures, std::ostream* out) { *out << figures.name; }

class SenaLog : public testing::TestWithParam<SenaFigures>
{
};

INSTANTIATE_TEST_SUITE_P(Golden, SenaLog,
                         testing::Values(SenaFigures{"Map", ReferenceChoice::Map, 7893},
                                         SenaFigures{"Keyframe", ReferenceChoice::Keyframe, 8522},
                                         SenaFigures{"Sequential", ReferenceChoice::Sequential,
                                                     10032}),
                         [](const auto& figures) -> std::string { return figures.param.name; });
}  // namespace

// One scan that is misplaced by a cell fills up to 361 new cells. The tolerance of 1 %, about 80
// cells, is less than a third of that, and bears what compilers round differently.
TEST_P(SenaLog, EveryScanIsMatchedAndTheMapIsSharp)
{
  if (!std::ifstream(kSena)) GTEST_SKIP() << kSena << " is not installed";
  constexpr double kTolerance = 0.01;
  const std::vector<PosedScan> scans = posedScans(GetParam().choice);
  ASSERT_EQ(scans.size(), 225U);
  for (std::size_t s = 1; s < scans.size(); ++s) EXPECT_TRUE(scans[s].isMatched()) << "scan " << s;
  const auto cells = static_cast<double>(GetParam().cells);
  EXPECT_LE(static_cast<double>(occupiedCells(scans)), (1 + kTolerance) * cells);
}
}  // namespace psmks
