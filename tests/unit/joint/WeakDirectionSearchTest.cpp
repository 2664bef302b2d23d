/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/core/Matcher.h>
#include <psmks/joint/WeakDirectionSearch.h>
#include <tests/support/Scenes.h>

namespace psmks
{
namespace
{
//  ------------.  .------------------.  .-----   y = 1     a corridor with two niches, 0.9 m wide
//              '--'    o ->  ->  o   '--'                  and 0.5 m deep; the scanner goes 3 m
//              from
//  -------------------------------------------   y = -1    o to o
std::vector<Wall> corridorWithNiches()
{
  return outline({{-20, -1},
                  {20, -1},
                  {20, 1},
                  {6.9, 1},
                  {6.9, 1.5},
                  {6, 1.5},
                  {6, 1},
                  {-0.1, 1},
                  {-0.1, 1.5},
                  {-1, 1.5},
                  {-1, 1},
                  {-20, 1}});
}

constexpr double kMoved_m = 3;

class WeakDirectionSearch : public testing::Test
{
 protected:
  Scan scanAt(double x_m)
  {
    constexpr double kReach_m = 8, kSigma_m = 0.01;
    const BeamGrid grid = BeamGrid::centered(2 * kPi, 720);
    return castScan(corridorWithNiches(), {x_m, 0, 0}, grid, kReach_m, kSigma_m, rng_);
  }

  /** From a guess that nobody measured: that the scanner stood still. */
  MatchResult match(const MatcherOptions& options)
  {
    MatcherWorkspace workspace;
    const Scan reference = scanAt(1), current = scanAt(1 + kMoved_m);
    return Matcher(options).match(reference, current, Guess{}, workspace);
  }

  std::mt19937 rng_{7};
};

Segment segment(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m)
{
  Segment s;
  s.firstEnd_m = from_m;
  s.lastEnd_m = to_m;
  return s;
}
}  // namespace

TEST_F(WeakDirectionSearch, AreLookedForBeyondTheSearchAboutTheGuess)
{
  const MatchResult result = match({});
  ASSERT_TRUE(result.usable()) << result.report();
  EXPECT_NEAR(result.T_ref_cur.x_m, kMoved_m, 0.02) << result.report();
  EXPECT_NEAR(result.T_ref_cur.y_m, 0, 0.01);
  EXPECT_NEAR(result.T_ref_cur.phi_rad, 0, degToRad(0.2));
}

TEST_F(WeakDirectionSearch, AreNearWhereTheWideSearchIsOff)
{
  MatcherOptions options;
  options.joint.wideRadius_m = 0;
  EXPECT_LT(match(options).T_ref_cur.x_m, options.joint.searchRadius_m + 0.1);
}

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
