/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/joint/LineVotes.h>
#include <tests/support/Scenes.h>

#include <algorithm>

namespace psmks
{
namespace
{
const VoteLimits kLimits{1.3, degToRad(60), 4};

struct Scene
{
  Scene(const std::vector<Wall>& walls, const Pose2& T_ref_cur, const BeamGrid& grid)
      : referenceScan(segmentByWalls(castScan(walls, {}, grid), walls, {})),
        currentScan(segmentByWalls(castScan(walls, T_ref_cur, grid), walls, T_ref_cur))
  {
    reference.build(referenceScan);
    current.build(currentScan);
  }

  /** Hypotheses about a guess, those with most votes first. */
  std::vector<Hypothesis> proposed(const Pose2& guess, const VoteLimits& limits = kLimits) const
  {
    LineVotes search;
    std::vector<Hypothesis> hypotheses;
    search.propose(reference, current, guess, limits, hypotheses);
    std::sort(hypotheses.begin(), hypotheses.end(),
              [](const Hypothesis& a, const Hypothesis& b) { return a.score > b.score; });
    return hypotheses;
  }

  SegmentedScan referenceScan, currentScan;
  ScanFeatures reference, current;
};

/** Place of the first hypothesis near a pose: 0 is the most voted one. */
std::size_t rankOf(const Pose2& truth, const std::vector<Hypothesis>& hypotheses)
{
  constexpr double kNear_m = 0.12, kNear_rad = degToRad(2);
  std::size_t rank = 0;
  for (const Hypothesis& h : hypotheses)
  {
    const double apart_m = (h.T_ref_cur.translation() - truth.translation()).norm();
    const double turned_rad = std::abs(wrapAngle(h.T_ref_cur.phi_rad - truth.phi_rad));
    if (apart_m < kNear_m && turned_rad < kNear_rad) return rank;
    ++rank;
  }
  return hypotheses.size();
}
}  // namespace

TEST(LineVotes, AKnownMotionIsAmongTheTopThree)
{
  const Pose2 motions[] = {{0, 0, 0},
                           {0.6, -0.3, degToRad(30)},
                           {-0.5, 0.4, degToRad(-45)},
                           {0.9, 0.2, 0.1},
                           {0.1, -0.8, degToRad(20)},
                           {-0.3, -0.3, degToRad(50)},
                           {0.5, 0.5, degToRad(-20)}};
  for (const Pose2& truth : motions)
    for (const int fieldOfView_deg : {180, 270, 360})
    {
      const Scene scene(officeRoom(), truth,
                        BeamGrid::centered(degToRad(fieldOfView_deg), fieldOfView_deg + 1));
      EXPECT_LT(rankOf(truth, scene.proposed({})), 3u)
          << truth.x_m << " m " << truth.y_m << " m " << radToDeg(truth.phi_rad) << " deg, field "
          << fieldOfView_deg << " deg";
    }
}

TEST(LineVotes, TheSearchIsAboutTheGuess)
{
  const Pose2 truth{1.5, 0.5, degToRad(80)};
  const Scene scene(officeRoom(), truth, BeamGrid::centered(2 * kPi, 360));
  EXPECT_LT(rankOf(truth, scene.proposed({1, 0, degToRad(60)})), 3u);
}

TEST(LineVotes, NothingIsProposedBeyondTheLimits)
{
  const Scene scene(officeRoom(), {0.9, 0.2, degToRad(10)}, BeamGrid::centered(2 * kPi, 360));
  const VoteLimits narrow{0.5, degToRad(15), 4};
  const std::vector<Hypothesis> hypotheses = scene.proposed({}, narrow);
  EXPECT_FALSE(hypotheses.empty());
  for (const Hypothesis& h : hypotheses)
  {
    EXPECT_LE(std::abs(h.T_ref_cur.x_m), narrow.radius_m);
    EXPECT_LE(std::abs(h.T_ref_cur.y_m), narrow.radius_m);
    EXPECT_LE(std::abs(h.T_ref_cur.phi_rad), narrow.angle_rad + degToRad(1));
  }
}

//  --------------      the walls say nothing of the position along them: the guess stays there
//      o   x
//  --------------
TEST(LineVotes, ALoneDirectionKeepsTheGuessAlongTheWalls)
{
  const Scene scene(corridor(), {0.5, 0.2, degToRad(10)}, BeamGrid::centered(kPi, 181));
  const std::vector<Hypothesis> hypotheses = scene.proposed({0.3, 0, 0});
  ASSERT_FALSE(hypotheses.empty());
  EXPECT_NEAR(hypotheses[0].T_ref_cur.x_m, 0.3, 0.1);
  EXPECT_NEAR(hypotheses[0].T_ref_cur.y_m, 0.2, 0.1);
  EXPECT_NEAR(hypotheses[0].T_ref_cur.phi_rad, degToRad(10), degToRad(1));
}

TEST(LineVotes, WithoutSegmentsNothingIsProposed)
{
  const Scene scene({}, {}, BeamGrid::centered(kPi, 181));
  EXPECT_TRUE(scene.proposed({}).empty());
}
}  // namespace psmks
