/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/mrpt/MapMatch.h>
#include <tests/support/PoseMatcher.h>
#include <tests/support/RandomNumbers.h>
#include <tests/support/Scenes.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace psmks::test
{
namespace
{
/** Points every 3 cm on walls, with noise of 1 cm. */
MapPoints pointsOn(const std::vector<Wall>& walls, RandomNumbers& random)
{
  MapPoints map;
  for (const Wall& wall : walls)
  {
    const double length_m = (wall.b - wall.a).norm();
    for (double s_m = 0; s_m < length_m; s_m += 0.03)
      map.points_m.push_back(wall.a + (wall.b - wall.a) * (s_m / length_m) +
                             Eigen::Vector2d(random.normal(0.01), random.normal(0.01)));
  }
  return map;
}

MapPoints seenFrom(const Pose2& T_world_robot, const std::vector<Wall>& walls,
                   RandomNumbers& random)
{
  MapPoints map = pointsOn(walls, random);
  const Pose2 T_robot_world = T_world_robot.inverse();
  for (Eigen::Vector2d& p : map.points_m) p = T_robot_world * p;
  return map;
}

/** A match with the options that programs use, and what it proposes where it is asked. */
class MapMatching : public testing::Test
{
 protected:
  MatchResult match(const MapPoints& reference, const MapPoints& current, const Guess& guess)
  {
    return MapMatch(options_, limits_, open_)
        .match(reference, current, guess, field_,
               [&]
               {
                 ++asked_;
                 return proposal_;
               });
  }

  RandomNumbers random_{11};
  RegistrationOptions options_;
  JointOptions limits_;
  Eigen::Matrix3d open_ = Eigen::Vector3d(4e-4, 4e-4, 1e-4).asDiagonal();
  SurfaceField field_;
  std::optional<Pose2> proposal_;
  int asked_ = 0;
};

const Pose2 kPose{0.6, -0.4, degToRad(25)};
const Pose2 kNear{0.7, -0.3, degToRad(20)};
}  // namespace

TEST_F(MapMatching, FindsThePoseOfAMap)
{
  SCOPED_TRACE(random_.seedText());
  const MatchResult result =
      match(pointsOn(officeRoom(), random_), seenFrom(kPose, officeRoom(), random_), {kNear, {}});
  EXPECT_EQ(result.status, MatchStatus::Converged) << result.report();
  EXPECT_TRUE(isNearly(result.T_ref_cur, kPose, 0.003, degToRad(0.1)));
  EXPECT_GT(result.score, 0.9);
  EXPECT_GT(result.associations, 500);
  EXPECT_EQ(result.hypotheses, 1);
  EXPECT_EQ(asked_, 0);
  EXPECT_LT(std::sqrt(result.covariance(0, 0)), 0.005);
}

//  Far off, another way to match says where to begin.
TEST_F(MapMatching, BeginsWhereItIsToldIfTheGuessLeadsNowhere)
{
  SCOPED_TRACE(random_.seedText());
  const MapPoints reference = pointsOn(officeRoom(), random_),
                  current = seenFrom(kPose, officeRoom(), random_);
  const Guess far{{-1.5, 1.2, degToRad(-60)}, {}};
  proposal_ = Pose2{kPose.x_m + 0.03, kPose.y_m, kPose.phi_rad};
  const MatchResult result = match(reference, current, far);
  EXPECT_EQ(asked_, 1);
  EXPECT_EQ(result.hypotheses, 2);
  EXPECT_TRUE(isNearly(result.T_ref_cur, kPose, 0.003, degToRad(0.1))) << result.report();
}

//  The map shows half of the room: what it does not show speaks not against the pose.
TEST_F(MapMatching, CountsNothingAgainstAPoseWhereTheMapIsUnknown)
{
  SCOPED_TRACE(random_.seedText());
  MapPoints reference = pointsOn(officeRoom(), random_);
  auto& points = reference.points_m;
  points.erase(std::remove_if(points.begin(), points.end(),
                              [](const Eigen::Vector2d& p) { return p.x() > 0; }),
               points.end());
  const MatchResult result = match(reference, seenFrom(kPose, officeRoom(), random_), {kNear, {}});
  EXPECT_TRUE(result.usable());
  EXPECT_GT(result.score, 0.8);
  EXPECT_TRUE(isNearly(result.T_ref_cur, kPose, 0.01, degToRad(0.2))) << result.report();
}

TEST_F(MapMatching, RefusesWhatTheMapDoesNotExplain)
{
  SCOPED_TRACE(random_.seedText());
  const MapPoints room = pointsOn(officeRoom(), random_);
  const Guess guess{{0, 0, 0}, {}};
  limits_.acceptScore = 0.95;
  const MatchResult elsewhere = match(room, pointsOn(clutteredRoom(3), random_), guess);
  EXPECT_EQ(elsewhere.status, MatchStatus::NoImprovement) << elsewhere.report();
  EXPECT_TRUE(isNearly(elsewhere.T_ref_cur, guess.T_ref_cur, 1e-12, 1e-12));

  MapPoints few;
  for (int i = 0; i < 5; ++i) few.points_m.push_back(room.points_m[static_cast<std::size_t>(i)]);
  EXPECT_EQ(match(room, few, guess).status, MatchStatus::TooFewAssociations);
  limits_.acceptScore = 0.05;
  EXPECT_TRUE(match(room, pointsOn(clutteredRoom(3), random_), guess).usable());
}

TEST_F(MapMatching, GivesTheCovarianceOfTheGuessOrThatOfOpenOnesInAFailure)
{
  const MapPoints empty;
  const Eigen::Matrix3d stated = 0.04 * Eigen::Matrix3d::Identity();
  const MatchResult open = match(empty, empty, {kNear, {}});
  EXPECT_EQ(open.status, MatchStatus::InvalidInput);
  EXPECT_EQ(open.covariance, open_);
  EXPECT_TRUE(isNearly(open.T_ref_cur, kNear, 1e-12, 1e-12));
  EXPECT_EQ(match(empty, empty, {kNear, stated}).covariance, stated);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const MatchResult nowhere = match(empty, empty, {{nan, 0, 0}, {}});
  EXPECT_EQ(nowhere.status, MatchStatus::InvalidInput);
  EXPECT_TRUE(isNearly(nowhere.T_ref_cur, {0, 0, 0}, 1e-12, 1e-12));
}

//  ======================
//        o ->               the place along the walls is open
//  ======================
TEST_F(MapMatching, TakesThePlaceAlongACorridorFromTheGuess)
{
  SCOPED_TRACE(random_.seedText());
  const std::vector<Wall> part{{{-6, -1}, {6, -1}}, {{-6, 1}, {6, 1}}};
  const MapPoints reference = pointsOn(corridor(), random_);
  const MapPoints current = seenFrom({0, 0, 0}, part, random_);
  const Pose2 guess{0.5, 0.05, degToRad(2)};
  const MatchResult result = match(reference, current, {guess, {}});
  ASSERT_TRUE(result.unobservableDirection) << result.report();
  EXPECT_EQ(result.status, MatchStatus::Degenerate);
  EXPECT_NEAR(std::abs(result.unobservableDirection->x()), 1, 1e-3);
  EXPECT_NEAR(result.T_ref_cur.x_m, 0.5, 1e-3);
  EXPECT_NEAR(result.T_ref_cur.y_m, 0, 0.005);
  EXPECT_NEAR(result.covariance(0, 0), open_(0, 0), 0.1 * open_(0, 0));

  const Eigen::Matrix3d stated = Eigen::Vector3d(0.09, 0.09, 0.01).asDiagonal();
  const MatchResult measured = match(reference, current, {guess, stated});
  EXPECT_NEAR(measured.covariance(0, 0), 0.09, 0.01);
  ASSERT_TRUE(measured.innovation);
  EXPECT_FALSE(measured.contradictsGuess());
}

TEST_F(MapMatching, SaysWhereAGuessIsContradicted)
{
  SCOPED_TRACE(random_.seedText());
  const Eigen::Matrix3d sure = Eigen::Vector3d(1e-4, 1e-4, 1e-4).asDiagonal();
  const MatchResult result =
      match(pointsOn(officeRoom(), random_), seenFrom(kPose, officeRoom(), random_), {kNear, sure});
  EXPECT_TRUE(result.usable());
  EXPECT_TRUE(result.contradictsGuess());
}

TEST_F(MapMatching, LooksAsFarAsItsFirstGate)
{
  SCOPED_TRACE(random_.seedText());
  const MapPoints reference = pointsOn(officeRoom(), random_),
                  current = seenFrom(kPose, officeRoom(), random_);
  const Guess guess{{kPose.x_m + 0.35, kPose.y_m - 0.2, kPose.phi_rad}, {}};
  EXPECT_TRUE(isNearly(match(reference, current, guess).T_ref_cur, kPose, 0.005, degToRad(0.1)));
  options_.thresholdDist = 0.02;
  const MatchResult narrow = match(reference, current, guess);
  EXPECT_FALSE(isNearly(narrow.T_ref_cur, kPose, 0.05, degToRad(1))) << narrow.report();
}

TEST_F(MapMatching, UsesOnePointOfSoMany)
{
  SCOPED_TRACE(random_.seedText());
  const MapPoints reference = pointsOn(officeRoom(), random_),
                  current = seenFrom(kPose, officeRoom(), random_);
  const int all = match(reference, current, {kNear, {}}).associations;
  options_.corresponding_points_decimation = 5;
  EXPECT_NEAR(match(reference, current, {kNear, {}}).associations, all / 5, all / 50);
}
}  // namespace psmks::test
