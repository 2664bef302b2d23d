/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/geometry/Angle.h>
#include <psmks/slam/CsvFiles.h>

#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace psmks
{
namespace
{
std::vector<std::string> fieldsOf(const std::string& line)
{
  std::vector<std::string> fields;
  std::istringstream in(line);
  for (std::string field; std::getline(in, field, ',');) fields.push_back(field);
  return fields;
}

std::vector<std::string> linesOf(const std::ostringstream& out)
{
  std::vector<std::string> lines;
  std::istringstream in(out.str());
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

ReferenceMatch matchTo(std::size_t reference, MatchStatus status)
{
  ReferenceMatch match;
  match.reference = reference;
  match.T_ref_cur.pose = {0.25, -0.5, degToRad(30)};
  match.T_ref_cur.covariance = Eigen::Vector3d(4e-6, 9e-6, 1e-4).asDiagonal();
  match.result.status = status;
  match.result.associations = 120;
  match.time_s = 0.002;
  return match;
}
}  // namespace

TEST(CsvFiles, MatchesStandInTheOrderOfTheirTrialAndOneOfThemDecides)
{
  std::vector<PosedScan> scans(3);
  for (std::size_t s = 0; s < 3; ++s) scans[s].scan.stamp_s = 100.5 + static_cast<double>(s);
  scans[2].decideBy(matchTo(0, MatchStatus::Converged));
  scans[2].matches.push_back(matchTo(1, MatchStatus::NoImprovement));
  std::ostringstream out;
  writeMatchesCsv(out, scans);

  const auto lines = linesOf(out);
  ASSERT_EQ(lines.size(), 3U);
  const auto names = fieldsOf(lines[0]), first = fieldsOf(lines[1]), second = fieldsOf(lines[2]);
  ASSERT_EQ(first.size(), names.size());
  EXPECT_EQ(names.front(), "stamp_s");
  EXPECT_EQ(names.back(), "decides");
  EXPECT_EQ(first[0], "102.500000000");
  EXPECT_EQ(first[1], "100.500000000");
  EXPECT_EQ(first[2], "Converged");
  EXPECT_EQ(first[5], "30");
  EXPECT_NEAR(std::stod(first[11]), 0.32828, 1e-5) << "1e-4 rad^2 in square degrees";
  EXPECT_EQ(first.back(), "1");
  EXPECT_EQ(second[1], "101.500000000");
  EXPECT_EQ(second.back(), "0");
}

TEST(CsvFiles, AMatchSaysWhatTheScansLeaveOpenAndHowFarTheGuessIs)
{
  std::vector<PosedScan> scans(2);
  ReferenceMatch match = matchTo(0, MatchStatus::Degenerate);
  match.result.unobservableDirection = Eigen::Vector2d::UnitX();
  match.result.ambiguity.emplace();
  match.result.ambiguity->alternatives = 2;
  match.result.innovation = Innovation{20.5, 2};
  scans[1].matches.push_back(match);
  std::ostringstream out;
  writeMatchesCsv(out, scans);

  const auto lines = linesOf(out);
  const auto names = fieldsOf(lines.at(0)), fields = fieldsOf(lines.at(1));
  const std::map<std::string, std::string> expected{
      {"direction_open", "1"},     {"direction_weak", "0"}, {"heading_open", "0"},
      {"alternatives", "2"},       {"innovation_dof", "2"}, {"guess_given_up", "0"},
      {"innovation_chi2", "20.5"}, {"status", "Degenerate"}};
  std::size_t found = 0;
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    const auto column = expected.find(names[i]);
    if (column == expected.end()) continue;
    ++found;
    EXPECT_EQ(fields.at(i), column->second) << names[i];
  }
  EXPECT_EQ(found, expected.size());
}

TEST(CsvFiles, ASegmentIsARow)
{
  ScanMap map;
  map.walls.push_back({{0, 1}, {2.5, 3}, 17, 0.004});
  std::ostringstream out;
  writeSegmentsCsv(out, map);
  EXPECT_EQ(out.str(), "x1_m,y1_m,x2_m,y2_m,points,sigma_m\n0,1,2.5,3,17,0.004\n");
}
}  // namespace psmks
