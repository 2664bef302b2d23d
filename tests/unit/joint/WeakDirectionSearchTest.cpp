/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/joint/WeakDirectionSearch.h>
#include <tests/unit/joint/JointScene.h>

#include <algorithm>

namespace psmks
{
namespace
{
constexpr double kPeriod_m = 1.6;

//   .--.     .--.     .--.     .--.        A corridor along x, 2 m wide, with a niche of 80 cm
//   every
// --'  '-----'  '-----'  '-----'  '--      1.6 m in one wall: shifted by a period it looks the same
//               o  ->                      within the reach of the scanner, which is 6 m.
// -----------------------------------
std::vector<Wall> corridorWithManyNiches()
{
  constexpr double kWide_m = 0.8, kDeep_m = 0.6;
  constexpr int kNiches = 20;
  std::vector<Eigen::Vector2d> corners_m{{-40, -1}, {40, -1}, {40, 1}};
  for (int k = kNiches; k >= -kNiches; --k)
  {
    const double right_m = kPeriod_m * k + kWide_m / 2, left_m = right_m - kWide_m;
    corners_m.insert(corners_m.end(),
                     {{right_m, 1}, {right_m, 1 + kDeep_m}, {left_m, 1 + kDeep_m}, {left_m, 1}});
  }
  corners_m.push_back({-40, 1});
  return outline(corners_m);
}

class WeakDirectionSearch : public testing::Test
{
 protected:
  /** Places along the corridor about a pose, looked for without a preference for near ones. */
  std::vector<Hypothesis> placesAbout(const Pose2& T_ref_cur, const AlongLimits& limits)
  {
    std::vector<Hypothesis> places{{{99, 99, 99}, 1, 1}};  // of an earlier search
    const ScanScores scores = scene_.scores();
    const HypothesisScore score(scores, {}, scene_.options);
    findPlacesAlong(score, T_ref_cur, Eigen::Vector2d::UnitX(), limits, places);
    return places;
  }

  static bool isAt(const Hypothesis& place, double x_m)
  {
    constexpr double kStep_m = 0.1;  // of the search
    return std::abs(place.T_ref_cur.x_m - x_m) <= kStep_m / 2 + 1e-9;
  }

  static bool holds(const std::vector<Hypothesis>& places, double x_m)
  {
    return std::any_of(places.begin(), places.end(),
                       [&](const Hypothesis& place) { return isAt(place, x_m); });
  }

  JointScene scene_{corridorWithManyNiches(), {}, BeamGrid::centered(2 * kPi, 720), 6};
  static constexpr AlongLimits kTwoPeriods{2.05 * kPeriod_m, 0, 8, 0.15};
};
}  // namespace

TEST_F(WeakDirectionSearch, PlacesThatLookAlikeAreFoundButNotThePoseItself)
{
  const std::vector<Hypothesis> places = placesAbout({}, kTwoPeriods);
  EXPECT_TRUE(holds(places, -kPeriod_m));
  EXPECT_TRUE(holds(places, kPeriod_m));
  EXPECT_FALSE(holds(places, 0));
  for (const Hypothesis& place : places)
  {
    EXPECT_EQ(place.T_ref_cur.y_m, 0);
    EXPECT_LE(std::abs(place.T_ref_cur.x_m), kTwoPeriods.reach_m);
  }
}

// A pose that is half a period wrong: the true places are at -0.8 and 0.8 m, and beyond.
TEST_F(WeakDirectionSearch, TheBestPlaceComesFirst)
{
  const std::vector<Hypothesis> places = placesAbout({kPeriod_m / 2, 0.02, 0}, kTwoPeriods);
  ASSERT_GE(places.size(), 2U);
  EXPECT_TRUE(isAt(places[0], 0)) << "the nearest to the guess of those that look alike";
  EXPECT_EQ(places[0].T_ref_cur.y_m, 0.02);
  EXPECT_TRUE(std::is_sorted(places.begin(), places.end(),
                             [](const Hypothesis& a, const Hypothesis& b)
                             { return a.score > b.score; }));
}

TEST_F(WeakDirectionSearch, NoMoreAreKeptThanAskedForAndThoseAreTheBest)
{
  AlongLimits two = kTwoPeriods;
  two.most = 2;
  const std::vector<Hypothesis> places = placesAbout({}, two);
  ASSERT_EQ(places.size(), 2U);
  EXPECT_TRUE(holds(places, kPeriod_m));
  EXPECT_TRUE(holds(places, -kPeriod_m));
}

// Half a period away niches meet walls: a place that scores much less than the best.
TEST_F(WeakDirectionSearch, PlacesThatScoreMuchLessAreDropped)
{
  AlongLimits strict = kTwoPeriods, lenient = kTwoPeriods;
  strict.missedPromise = 0.1;
  lenient.missedPromise = 1;
  const std::vector<Hypothesis> few = placesAbout({}, strict), many = placesAbout({}, lenient);
  double best = 0;
  for (const Hypothesis& place : many) best = std::max(best, place.score);
  for (const Hypothesis& place : few) EXPECT_GE(place.score, best - 0.11);
  EXPECT_GE(many.size(), few.size());
  EXPECT_FALSE(holds(few, kPeriod_m / 2));
}

// The pose is turned by 1 degree: 3.2 m along the true place is found with the heading put right.
TEST_F(WeakDirectionSearch, FarAlongAHeadingThatIsALittleWrongIsPutRight)
{
  AlongLimits turning = kTwoPeriods;
  turning.turn_rad = degToRad(4);
  const std::vector<Hypothesis> places = placesAbout({0, 0, degToRad(4)}, turning);
  const auto far = std::find_if(places.begin(), places.end(),
                                [](const Hypothesis& place) { return isAt(place, 2 * kPeriod_m); });
  ASSERT_NE(far, places.end());
  EXPECT_NEAR(far->T_ref_cur.phi_rad, 0, 1e-9);
  for (const Hypothesis& place : placesAbout({0, 0, degToRad(4)}, kTwoPeriods))
    EXPECT_EQ(place.T_ref_cur.phi_rad, degToRad(4)) << "no turn was asked for";
}

TEST_F(WeakDirectionSearch, AsManyPlacesAsSaidAreLookedAt)
{
  const ScanScores scores = scene_.scores();
  const HypothesisScore score(scores, {}, scene_.options);
  std::vector<Hypothesis> places;
  places.reserve(mostPlacesAlong(3));
  const Hypothesis* memory = places.data();
  findPlacesAlong(score, {}, Eigen::Vector2d::UnitX(), {3, 0, 8, 0.15}, places);
  EXPECT_EQ(places.data(), memory) << "it took more memory than that of mostPlacesAlong()";
}

namespace
{
Segment segment(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m)
{
  Segment s;
  s.firstEnd_m = from_m;
  s.lastEnd_m = to_m;
  return s;
}
}  // namespace

//      ____          walls of 4 and 3 m along 30 degrees, one of them walked the other way, and one
//     /    ____/     of 2 m across them, which counts against
//    /____/
TEST(DirectionOfWalls, IsThatOfMostLength)
{
  const Eigen::Vector2d along(std::cos(degToRad(30)), std::sin(degToRad(30)));
  const Eigen::Vector2d across(-along.y(), along.x());
  const Eigen::Vector2d found =
      directionOfWalls({segment({0, 0}, 4 * along), segment(across + 3 * along, across),
                        segment({0, 0}, 2 * across)});
  EXPECT_NEAR(std::abs(found.dot(along)), 1, 1e-12);
}

TEST(DirectionOfWalls, IsADirectionEvenWithoutWalls)
{
  EXPECT_NEAR(directionOfWalls({}).norm(), 1, 1e-12);
}
}  // namespace psmks
