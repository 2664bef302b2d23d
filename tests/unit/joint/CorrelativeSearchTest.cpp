/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/core/Matcher.h>
#include <psmks/joint/CorrelativeSearch.h>
#include <tests/support/PoseMatcher.h>
#include <tests/support/RandomNumbers.h>
#include <tests/unit/joint/JointScene.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace psmks
{
namespace
{
constexpr double kTolerance_m = 0.04;
constexpr std::size_t kMost = 16;

bool isSameList(const std::vector<Hypothesis>& a, const std::vector<Hypothesis>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Hypothesis& x, const Hypothesis& y)
                    { return x.score == y.score && isNearly(x.T_ref_cur, y.T_ref_cur, 0, 0); });
}

/** The search that is to be found again by scoring every pose of the window, one after the other.
 *
 * The current scan has so few rays, so far apart, that each is a look of its own: then the search
 * scores all of them but those on movable objects, and these too if they are most. */
class EveryPose
{
 public:
  EveryPose(const ScanFeatures& reference, const ScanFeatures& current, const Pose2& guess,
            const SearchWindow& window)
      : guess_(guess)
  {
    const RayPoints& points = current.points;
    EXPECT_TRUE(points.size() <= CorrelativeSearch::kMostRays &&
                std::all_of(points.looks.begin(), points.looks.end(),
                            [](float looks) { return looks == 1; }))
        << "the search does not score each ray of this scan";
    const auto movable = std::count(points.movable.begin(), points.movable.end(), 1);
    const bool keepsMovable = 2 * static_cast<std::size_t>(movable) > points.size();
    for (std::size_t i = 0; i < points.size(); ++i)
      if (keepsMovable || !points.movable[i]) rays_m_.emplace_back(points.x_m[i], points.y_m[i]);
    grid_.build(reference, window.radius_m, kTolerance_m);
    findTurn();
    headings_ = static_cast<int>(std::ceil(window.angle_rad / turn_rad_));
    moves_ = static_cast<int>(std::ceil(window.radius_m / grid_.cell_m()));
    scoreAll();
  }

  std::size_t poses() const { return scores_.size(); }

  /** Checks that a list is that of greedy suppression: of the poses that are no start of the list
   * before, always one that no other beats, until there are enough or the rest is hopeless. */
  void expectFound(const std::vector<Hypothesis>& list, std::size_t most) const
  {
    const int best = *std::max_element(scores_.begin(), scores_.end());
    ASSERT_EQ(list.empty(), best <= 0 || most == 0);
    for (std::size_t k = 0; k < list.size(); ++k)
    {
      const int score = scoreOf(list[k]);
      EXPECT_DOUBLE_EQ(list[k].score, share(score)) << "the score of its pose, hypothesis " << k;
      EXPECT_EQ(posesBetterThan(score, list, k), 0) << "than hypothesis " << k;
      EXPECT_GT(2 * score, best);
      for (std::size_t other = 0; other < k; ++other)
        EXPECT_FALSE(isSameStart(list[k].T_ref_cur, list[other].T_ref_cur)) << k << ' ' << other;
    }
    EXPECT_LE(list.size(), most);
    if (list.size() < most)
    {
      EXPECT_EQ(posesBetterThan(best / 2, list, list.size()), 0)
          << "and more than half of the best";
    }
  }

 private:
  /** Steps that move half of the rays by at most two cells, between 1 and 3 degrees. */
  void findTurn()
  {
    std::vector<double> distances_m;
    for (const Eigen::Vector2f& ray_m : rays_m_)
      distances_m.push_back(static_cast<double>(std::hypot(ray_m.x(), ray_m.y())));
    std::sort(distances_m.begin(), distances_m.end());
    const double median_m = distances_m[distances_m.size() / 2];
    turn_rad_ = std::min(std::max(2 * grid_.cell_m() / median_m, degToRad(1)), degToRad(3));
  }

  void scoreAll()
  {
    const int side = 2 * moves_ + 1;
    scores_.assign(static_cast<std::size_t>((2 * headings_ + 1) * side * side), 0);
    for (int heading = 0; heading <= 2 * headings_; ++heading)
    {
      const double phi_rad = guess_.phi_rad + (heading - headings_) * turn_rad_;
      const auto c = static_cast<float>(std::cos(phi_rad)),
                 s = static_cast<float>(std::sin(phi_rad));
      const auto x0 = static_cast<float>(guess_.x_m), y0 = static_cast<float>(guess_.y_m);
      for (const Eigen::Vector2f& ray_m : rays_m_)
      {
        const int cell =
            grid_.indexOf(c * ray_m.x() - s * ray_m.y() + x0, s * ray_m.x() + c * ray_m.y() + y0);
        if (cell < 0) continue;
        for (int x = -moves_; x <= moves_; ++x)
          for (int y = -moves_; y <= moves_; ++y)
            scores_[indexOf(heading, x, y)] += grid_.level(0)[cell + grid_.offset(x, y)];
      }
    }
  }

  std::size_t indexOf(int heading, int x, int y) const
  {
    const int side = 2 * moves_ + 1;
    return static_cast<std::size_t>((heading * side + x + moves_) * side + y + moves_);
  }

  Pose2 poseAt(int heading, int x, int y) const
  {
    return {guess_.x_m + x * grid_.cell_m(), guess_.y_m + y * grid_.cell_m(),
            wrapAngle(guess_.phi_rad + (heading - headings_) * turn_rad_)};
  }

  /** The score of a pose that is one of the grid. */
  int scoreOf(const Hypothesis& hypothesis) const
  {
    const Pose2& T = hypothesis.T_ref_cur;
    const auto x = static_cast<int>(std::lround((T.x_m - guess_.x_m) / grid_.cell_m()));
    const auto y = static_cast<int>(std::lround((T.y_m - guess_.y_m) / grid_.cell_m()));
    int heading = -1;
    for (int k = 0; k <= 2 * headings_; ++k)
      if (std::abs(wrapAngle(poseAt(k, 0, 0).phi_rad - T.phi_rad)) < 1e-9) heading = k;
    const bool isOfTheGrid = std::abs(x) <= moves_ && std::abs(y) <= moves_ && heading >= 0;
    EXPECT_TRUE(isOfTheGrid && isNearly(T, poseAt(heading, x, y), 1e-9, 1e-9));
    return isOfTheGrid ? scores_[indexOf(heading, x, y)] : 0;
  }

  /** Poses with a higher score that are another start than the first so many of a list. */
  int posesBetterThan(int score, const std::vector<Hypothesis>& list, std::size_t first) const
  {
    int better = 0;
    for (int heading = 0; heading <= 2 * headings_; ++heading)
      for (int x = -moves_; x <= moves_; ++x)
        for (int y = -moves_; y <= moves_; ++y)
        {
          if (scores_[indexOf(heading, x, y)] <= score) continue;
          const auto end = list.begin() + static_cast<std::ptrdiff_t>(first);
          const Pose2 pose = poseAt(heading, x, y);
          better += std::none_of(list.begin(), end,
                                 [&](const Hypothesis& known)
                                 { return isSameStart(pose, known.T_ref_cur); });
        }
    return better;
  }

  double share(int score) const
  {
    return score / (static_cast<double>(rays_m_.size()) * EvidenceGrid::kOnSurface);
  }

  EvidenceGrid grid_;
  Pose2 guess_;
  std::vector<Eigen::Vector2f> rays_m_;
  double turn_rad_ = 0;
  int headings_ = 0, moves_ = 0;
  std::vector<int> scores_;
};

/** Two scans of a cluttered room, the current one of 30 rays. Nothing is nearer to its scanner than
 * 1.2 m, where each of 30 rays is a look. */
class RandomScene
{
 public:
  explicit RandomScene(test::RandomNumbers& random, double scale = 1.5)
      : walls_(scaledRoom(static_cast<unsigned>(random.integer(1, 1000)), scale)),
        T_ref_cur(
            {random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4), random.uniform(-kPi, kPi)}),
        scene_(scanFrom({}, BeamGrid::centered(random.uniform(kPi, 2 * kPi), 361), 20 * scale),
               scanFrom(T_ref_cur, BeamGrid::centered(2 * kPi, 30), 20 * scale))
  {
  }

  const ScanFeatures& reference() const { return scene_.buffers.reference; }
  const ScanFeatures& current() const { return scene_.buffers.current; }

 private:
  static std::vector<Wall> scaledRoom(unsigned seed, double scale)
  {
    std::vector<Wall> walls = clutteredRoom(seed);
    for (Wall& wall : walls) wall.a *= scale, wall.b *= scale;
    return walls;
  }

  SegmentedScan scanFrom(const Pose2& T, const BeamGrid& grid, double maxRange_m) const
  {
    return segmentByWalls(castScan(walls_, T, grid, maxRange_m), walls_, T);
  }

  std::vector<Wall> walls_;

 public:
  const Pose2 T_ref_cur;

 private:
  JointScene scene_;
};

std::vector<Hypothesis> found(const RandomScene& scene, const Pose2& guess,
                              const SearchWindow& window, std::size_t most,
                              CorrelativeSearch& search)
{
  std::vector<Hypothesis> hypotheses{{{99, 99, 99}, 1}};  // of an earlier search
  search.propose(scene.reference(), scene.current(), guess, window, kTolerance_m, most, hypotheses);
  return hypotheses;
}
}  // namespace

// ---- against scoring every pose -----------------------------------------------------------------

TEST(CorrelativeSearchLaw, FindsWhatScoringEveryPoseFinds)
{
  CorrelativeSearch search;
  std::size_t windows = 0, several = 0;
  for (unsigned seed = 1; seed <= 12; ++seed)
  {
    test::RandomNumbers random(seed);
    SCOPED_TRACE(random.seedText());
    const RandomScene scene(random);
    for (const SearchWindow& window :
         {SearchWindow{1.3, degToRad(60)}, SearchWindow{0.32, degToRad(7)},
          SearchWindow{0.05, degToRad(30)}, SearchWindow{0.7, 0}, SearchWindow{2.1, degToRad(120)},
          SearchWindow{0.15, kPi}})
    {
      const Pose2 guess{random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5),
                        random.uniform(-kPi, kPi)};
      const auto most = static_cast<std::size_t>(random.integer(1, 20));
      SCOPED_TRACE("window " + std::to_string(window.radius_m) + " m, " +
                   std::to_string(radToDeg(window.angle_rad)) + " deg");
      const EveryPose every(scene.reference(), scene.current(), guess, window);
      const std::vector<Hypothesis> hypotheses = found(scene, guess, window, most, search);
      every.expectFound(hypotheses, most);
      windows += !hypotheses.empty();
      several += hypotheses.size() > 1;
    }
  }
  EXPECT_GT(windows, 20U) << "with a pose for which more speaks than against it";
  EXPECT_GT(several, 10U);
}

TEST(CorrelativeSearchLaw, FindsTheSameInTheWidestWindow)
{
  test::RandomNumbers random(77);
  SCOPED_TRACE(random.seedText());
  const RandomScene scene(random);
  const SearchWindow wide{5, kPi};
  const EveryPose every(scene.reference(), scene.current(), {}, wide);
  EXPECT_GT(every.poses(), 500000U);
  CorrelativeSearch search;
  const std::vector<Hypothesis> hypotheses = found(scene, {}, wide, kMost, search);
  every.expectFound(hypotheses, kMost);
  EXPECT_TRUE(std::any_of(hypotheses.begin(), hypotheses.end(),
                          [&](const Hypothesis& start) {
                            return isNearly(start.T_ref_cur, scene.T_ref_cur, 0.15, degToRad(3));
                          }))
      << "the truth is among them";
}

// A room of 60 x 48 m, whose grid has coarser cells.
TEST(CorrelativeSearchLaw, FindsTheSameInALargeRoom)
{
  test::RandomNumbers random(5);
  SCOPED_TRACE(random.seedText());
  const RandomScene scene(random, 6);
  CorrelativeSearch search;
  for (const SearchWindow& window : {SearchWindow{5, degToRad(60)}, SearchWindow{1.3, kPi}})
  {
    const Pose2 guess{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-kPi, kPi)};
    const EveryPose every(scene.reference(), scene.current(), guess, window);
    every.expectFound(found(scene, guess, window, kMost, search), kMost);
  }
}

TEST(CorrelativeSearchLaw, ASearchIsNotAffectedByThoseBefore)
{
  test::RandomNumbers random(9);
  SCOPED_TRACE(random.seedText());
  const RandomScene one(random), other(random, 2);
  CorrelativeSearch used;
  used.reserve();
  for (const double radius_m : {2.0, 0.2, 1.0, 0.0, 2.0})
    for (const RandomScene* scene : {&one, &other})
    {
      const SearchWindow window{radius_m, degToRad(30 * radius_m + 10)};
      CorrelativeSearch fresh;
      EXPECT_TRUE(isSameList(found(*scene, {0.1, 0.2, 0.3}, window, kMost, used),
                             found(*scene, {0.1, 0.2, 0.3}, window, kMost, fresh)))
          << radius_m;
    }
}

// ---- in an office -------------------------------------------------------------------------------

namespace
{
// The room of officeRoom(): the scanner has gone 2.2 m and turned by 75 degrees.
const Pose2 kFar{1.4, 1.7, degToRad(75)};
const BeamGrid kAround = BeamGrid::centered(2 * kPi, 360);

/** The truth lies within half a cell in x and y, and half a step of the heading, which is 3 degrees
 * at most, of a pose of the grid. Cells and tolerance hide as much again. */
const double kNear_m = 0.1 * std::sqrt(2), kNear_rad = degToRad(3);

class CorrelativeSearchTest : public testing::Test
{
 protected:
  std::vector<Hypothesis> startsAbout(const Pose2& guess, const SearchWindow& window,
                                      std::size_t most = kMost)
  {
    std::vector<Hypothesis> starts{{{99, 99, 99}, 1}};  // of an earlier search
    search_.propose(scene_.buffers.reference, scene_.buffers.current, guess, window, kTolerance_m,
                    most, starts);
    return starts;
  }

  /** In the middle of a square room with a chest in one corner: turned by 90 degrees it looks
   * nearly the same. */
  std::vector<Hypothesis> startsInARoom(std::size_t most)
  {
    std::vector<Wall> walls = squareRoom();
    for (const Wall& side : box({-2.7, -2.7}, 0.6, 0.6)) walls.push_back(side);
    JointScene room(walls, {}, kAround);
    std::vector<Hypothesis> starts;
    search_.propose(room.buffers.reference, room.buffers.current, {}, {1, degToRad(120)},
                    kTolerance_m, most, starts);
    return starts;
  }

  JointScene scene_{officeRoom(), kFar, kAround};
  CorrelativeSearch search_;
  static constexpr SearchWindow kWide{3, degToRad(120)};
};
}  // namespace

TEST_F(CorrelativeSearchTest, TheStartThatExplainsMostIsTheTruth)
{
  for (const Pose2& guess : {Pose2{}, Pose2{0.27, 0.38, degToRad(-20)}, Pose2{-0.6, 0.9, 2}})
  {
    const std::vector<Hypothesis> starts = startsAbout(guess, kWide);
    ASSERT_FALSE(starts.empty());
    EXPECT_TRUE(isNearly(starts[0].T_ref_cur, kFar, kNear_m, kNear_rad));
  }
}

TEST_F(CorrelativeSearchTest, WhereAllRaysLieOnSurfacesTheScoreIsOne)
{
  JointScene scene(squareRoom(), {0.3, 0.2, 0.1}, kAround);
  std::vector<Hypothesis> starts;
  search_.propose(scene.buffers.reference, scene.buffers.current, {0.3, 0.2, 0.1}, {0.05, 0.001},
                  kTolerance_m, 1, starts);
  ASSERT_EQ(starts.size(), 1U);
  EXPECT_EQ(starts[0].score, 1);
  EXPECT_TRUE(isNearly(starts[0].T_ref_cur, {0.3, 0.2, 0.1}, 1e-9, 1e-9));
}

TEST_F(CorrelativeSearchTest, StartsComeInTheOrderOfTheirScores)
{
  const std::vector<Hypothesis> starts = startsInARoom(kMost);
  ASSERT_GT(starts.size(), 2U);
  EXPECT_GT(starts[0].score, starts[1].score) << "the chest tells";
  EXPECT_TRUE(std::is_sorted(starts.begin(), starts.end(),
                             [](const Hypothesis& a, const Hypothesis& b)
                             { return a.score > b.score; }));
  EXPECT_GT(starts.back().score, starts.front().score / 2);
}

// Two starts within the gates of the refinement would lead to one pose.
TEST_F(CorrelativeSearchTest, NoTwoStartsLeadToOnePlace)
{
  const std::vector<Hypothesis> starts = startsInARoom(kMost);
  for (const Hypothesis& a : starts)
    for (const Hypothesis& b : starts)
      EXPECT_TRUE(&a == &b || !isSameStart(a.T_ref_cur, b.T_ref_cur));
}

TEST_F(CorrelativeSearchTest, StartsAreWithinTheWindowAboutTheGuess)
{
  const SearchWindow narrow{0.95, degToRad(28)};
  const double cell_m = 0.1, turn_rad = degToRad(3);  // to which the window is rounded up, at most
  for (const Pose2& off : {Pose2{0.9, 0.9, degToRad(25)}, Pose2{-0.9, 0.2, degToRad(-25)},
                           Pose2{-0.98, 0.97, degToRad(29)}})
  {
    const Pose2 guess{kFar.x_m + off.x_m, kFar.y_m + off.y_m, kFar.phi_rad + off.phi_rad};
    const std::vector<Hypothesis> starts = startsAbout(guess, narrow);
    EXPECT_FALSE(starts.empty());
    for (const Hypothesis& start : starts)
    {
      const Pose2& T = start.T_ref_cur;
      EXPECT_LE((T.translation() - guess.translation()).cwiseAbs().maxCoeff(),
                narrow.radius_m + cell_m);
      EXPECT_LE(std::abs(wrapAngle(T.phi_rad - guess.phi_rad)), narrow.angle_rad + turn_rad);
    }
  }
}

// Where more speaks against every pose than for it there is nothing to return.
TEST_F(CorrelativeSearchTest, AWindowInWhichNoPoseIsRightIsEmpty)
{
  EXPECT_TRUE(startsAbout({0.2, -0.3, degToRad(175)}, {0.3, degToRad(10)}).empty());
}

TEST_F(CorrelativeSearchTest, ARadiusOfZeroTriesHeadingsAlone)
{
  for (const Hypothesis& start : startsAbout({0.4, 0.3, 0}, {0, degToRad(120)}))
    EXPECT_EQ(start.T_ref_cur.translation(), Eigen::Vector2d(0.4, 0.3));
}

TEST_F(CorrelativeSearchTest, NoMoreStartsComeThanAreAskedForAndThoseAreTheBest)
{
  const std::vector<Hypothesis> all = startsInARoom(kMost), two = startsInARoom(2);
  ASSERT_GT(all.size(), 2U);
  ASSERT_EQ(two.size(), 2U);
  EXPECT_TRUE(isSameList(two, {all.begin(), all.begin() + 2}));
  EXPECT_TRUE(startsAbout({}, kWide, 0).empty());
}

TEST_F(CorrelativeSearchTest, AScanWithoutRaysHasNoStart)
{
  const std::vector<Wall> nothing;
  JointScene empty(nothing, {}, kAround);
  std::vector<Hypothesis> starts{{{99, 99, 99}, 1}};
  search_.propose(scene_.buffers.reference, empty.buffers.current, {}, kWide, kTolerance_m, kMost,
                  starts);
  EXPECT_TRUE(starts.empty()) << "nothing to explain";
  starts = {{{99, 99, 99}, 1}};
  search_.propose(empty.buffers.reference, scene_.buffers.current, {}, kWide, kTolerance_m, kMost,
                  starts);
  EXPECT_TRUE(starts.empty()) << "nothing that explains it";
}

TEST_F(CorrelativeSearchTest, AboutAGuessFarFromAllThatWasSeenThereIsNoStart)
{
  EXPECT_TRUE(startsAbout({200, 0, 0}, kWide).empty());
  EXPECT_TRUE(startsAbout({1e12, -1e12, 1}, kWide).empty());
}

//  +----------+
//  |   P  P   |    People have come who stand about the scanner: what lies on them is in space that
//  |     o P  |    was seen free, but they are objects that may have moved.
//  +----------+
TEST(CorrelativeSearch, RaysOnMovableObjectsAreNotScored)
{
  std::vector<Wall> withPeople = officeRoom();
  for (const Eigen::Vector2d& person_m : {Eigen::Vector2d(0, 1.2), Eigen::Vector2d(1.3, 0.5),
                                          Eigen::Vector2d(-1, -1), Eigen::Vector2d(0.6, -1.2)})
    for (const Wall& side : box(person_m, 0.45, 0.45, person_m.x())) withPeople.push_back(side);
  const Pose2 T{0.1, 0.1, 0};
  const auto scanOf = [](const std::vector<Wall>& walls, const Pose2& pose)
  { return segmentByWalls(castScan(walls, pose, kAround), walls, pose); };
  JointScene scene(scanOf(officeRoom(), {}), scanOf(withPeople, T));
  const std::vector<std::uint8_t>& movable = scene.buffers.current.points.movable;
  ASSERT_GT(std::count(movable.begin(), movable.end(), 1), 80);
  CorrelativeSearch search;
  std::vector<Hypothesis> starts;
  search.propose(scene.buffers.reference, scene.buffers.current, T, {0.05, 0.001}, kTolerance_m, 1,
                 starts);
  ASSERT_EQ(starts.size(), 1U);
  EXPECT_GT(starts[0].score, 0.96) << "with those rays 0.73";
}

//     []    o   []    nothing but objects that may have moved: then they are what there is
TEST(CorrelativeSearch, WhereMostRaysAreOnMovableObjectsTheyAreScored)
{
  std::vector<Wall> walls;
  for (const Eigen::Vector2d& centre_m : {Eigen::Vector2d(2, 0.3), Eigen::Vector2d(-1, 1.9),
                                          Eigen::Vector2d(-1.5, -1.4), Eigen::Vector2d(0.9, -2.2)})
    for (const Wall& side : box(centre_m, 0.4, 0.3, centre_m.x())) walls.push_back(side);
  const Pose2 T{0.2, -0.1, degToRad(20)};
  JointScene scene(walls, T, kAround);
  const std::vector<std::uint8_t>& movable = scene.buffers.current.points.movable;
  ASSERT_EQ(std::count(movable.begin(), movable.end(), 0), 0);
  CorrelativeSearch search;
  std::vector<Hypothesis> starts;
  search.propose(scene.buffers.reference, scene.buffers.current, {}, {0.5, degToRad(40)},
                 kTolerance_m, kMost, starts);
  EXPECT_TRUE(std::any_of(starts.begin(), starts.end(),
                          [&](const Hypothesis& start)
                          { return isNearly(start.T_ref_cur, T, 0.2, degToRad(5)); }));
}

TEST(IsSameStart, IsLessThan30CentimetresAnd5DegreesApart)
{
  const Pose2 a{1, 2, degToRad(179)};
  EXPECT_TRUE(isSameStart(a, a));
  EXPECT_TRUE(isSameStart(a, {1.2, 2.2, degToRad(179)}));
  EXPECT_FALSE(isSameStart(a, {1.22, 2.22, degToRad(179)}));
  EXPECT_TRUE(isSameStart(a, {1, 2, degToRad(-176.1)})) << "across the seam";
  EXPECT_FALSE(isSameStart(a, {1, 2, degToRad(-175.9)}));
}

// One match through all steps, which the parts alone do not hold: the wide search is made where
// nothing near the guess is found, and leads to the pose.
TEST(CorrelativeSearch, FindsWhatIsFartherThanTheSearchAboutTheGuess)
{
  MatcherWorkspace workspace;
  const MatchResult result =
      Matcher().match(castScan(officeRoom(), {}, kAround), castScan(officeRoom(), kFar, kAround),
                      Guess{}, workspace);
  ASSERT_TRUE(result.usable()) << result.report();
  // The scans are exact: what is left is the rounding of the search's steps.
  EXPECT_TRUE(isNearly(result.T_ref_cur, kFar, 0.01, degToRad(0.2))) << result.report();
}
}  // namespace psmks
