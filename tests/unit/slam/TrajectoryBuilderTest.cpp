/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/slam/TrajectoryBuilder.h>
#include <tests/support/PoseMatcher.h>
#include <tests/support/Scenes.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace psmks
{
namespace
{
/** Knows where each scan was taken (by its stamp), and fails for those it is told to: always, or
 * only against one reference. */
class Oracle : public PairMatcher
{
 public:
  static constexpr double kAlways = -1;

  std::map<double, Pose2> T_world_sensor;
  std::map<double, double> fails;                      //!< stamp of the scan, of the reference
  std::map<std::pair<double, double>, double> scores;  //!< by both stamps; else 1
  std::map<std::pair<double, double>, double> off_m;   //!< error of x, by both stamps; else 0

  /** Stamp of a scan that it fails for unless the guess is as uncertain as this. */
  std::map<double, double> needsSigma_m;

  /** Stamps of scans in which nothing was seen, and of scans that contradict their guess. */
  std::set<double> blind, contradicts;

  std::string name() const override { return "oracle"; }
  MatchResult match(const Scan& reference, const Scan& current, const Guess& guess) override
  {
    MatchResult result;
    const auto failure = fails.find(current.stamp_s);
    const auto needed = needsSigma_m.find(current.stamp_s);
    const bool tooSure =
        needed != needsSigma_m.end() && std::sqrt((*guess.covariance)(0, 0)) < needed->second;
    const bool failed =
        tooSure || (failure != fails.end() &&
                    (failure->second == kAlways || failure->second == reference.stamp_s));
    if (blind.count(current.stamp_s) > 0)
    {
      result.status = MatchStatus::InvalidInput;
      result.T_ref_cur = guess.T_ref_cur;
      result.covariance = *guess.covariance;
      return result;
    }
    result.guessGivenUp = contradicts.count(current.stamp_s) > 0;
    result.status = failed ? MatchStatus::NoImprovement : MatchStatus::Converged;
    result.T_ref_cur = failed ? guess.T_ref_cur
                              : T_world_sensor.at(reference.stamp_s).inverse() *
                                    T_world_sensor.at(current.stamp_s);
    result.covariance =
        failed ? *guess.covariance : Eigen::Matrix3d(1e-6 * Eigen::Matrix3d::Identity());
    const auto off = off_m.find({current.stamp_s, reference.stamp_s});
    if (!failed && off != off_m.end()) result.T_ref_cur.x_m += off->second;
    const auto score = scores.find({current.stamp_s, reference.stamp_s});
    result.score = score != scores.end() ? score->second : 1;
    result.associations = 100;
    return result;
  }
};

ReferenceOptions sequential()
{
  ReferenceOptions options;
  options.choice = ReferenceChoice::Sequential;
  return options;
}

/** A robot that drives 0.3 m a step and curves, with a scanner ahead and aside of its centre. */
class TrajectoryBuilderTest : public testing::Test
{
 protected:
  const Pose2 T_robot_sensor_{0.4, 0.2, degToRad(20)};
  const Pose2 trueStep_{0.3, 0, degToRad(5)}, measuredStep_{0.33, 0, degToRad(4)};

  Pose2 truth(int i) const
  {
    Pose2 T;
    for (int k = 0; k < i; ++k) T = T * trueStep_;
    return T;
  }

  /** Scans 0 to count - 1, with the stamps 0, 1, ... */
  std::vector<PosedScan> build(int count, const std::map<double, double>& fails,
                               const ReferenceOptions& options = sequential(),
                               bool odometry = true) const
  {
    Oracle oracle;
    oracle.fails = fails;
    return buildBy(oracle, count, options, odometry);
  }

  std::vector<PosedScan> buildBy(const Oracle& tellsOf, int count,
                                 const ReferenceOptions& options = sequential(),
                                 bool odometry = true) const
  {
    auto oracle = std::make_unique<Oracle>(tellsOf);
    for (int i = 0; i < count; ++i) oracle->T_world_sensor[i] = truth(i) * T_robot_sensor_;
    TrajectoryBuilder builder(std::move(oracle), options, OdometryOptions());
    for (int i = 0; i < count; ++i)
    {
      Scan scan;
      scan.stamp_s = i;
      scan.grid = BeamGrid::centered(kPi, 3);
      scan.range_m.assign(3, tellsOf.blind.count(i) > 0 ? 0 : 1);
      builder.add(scan, T_robot_sensor_,
                  odometry && i > 0 ? std::optional(measuredStep_) : std::nullopt);
    }
    return builder.scans();
  }
};

TEST_F(TrajectoryBuilderTest, MatchedScansStandWhereTheRobotStoodNotTheSensor)
{
  const auto scans = build(6, {});
  for (int i = 0; i < 6; ++i)
    EXPECT_TRUE(
        isNearly(scans[static_cast<std::size_t>(i)].T_world_robot.pose, truth(i), 1e-9, 1e-9));
  EXPECT_TRUE(isNearly(scans[3].T_last_robot.pose, trueStep_, 1e-9, 1e-9));
  EXPECT_TRUE(isNearly(scans[2].T_world_odometry, measuredStep_ * measuredStep_, 1e-9, 1e-9));
}

TEST_F(TrajectoryBuilderTest, TheReferenceIsReplacedAtTheTrigger)
{
  const auto scans = build(7, {});  // 0.3 m a step, trigger 0.8 m
  for (const std::size_t reference : {0u, 3u, 6u}) EXPECT_TRUE(scans[reference].isReference);
  for (const std::size_t other : {1u, 2u, 4u, 5u}) EXPECT_FALSE(scans[other].isReference);
  EXPECT_EQ(scans[3].decidingMatch()->reference, 0u);
  EXPECT_EQ(scans[5].decidingMatch()->reference, 3u);
}

TEST_F(TrajectoryBuilderTest, ThePaperPosesTheScansBetweenTriggersByOdometry)
{
  ReferenceOptions paper = sequential();
  paper.matchEveryScan = false;
  const auto scans = build(4, {}, paper);
  EXPECT_TRUE(scans[1].matches.empty());
  EXPECT_TRUE(isNearly(scans[2].T_world_robot.pose, measuredStep_ * measuredStep_, 1e-9, 1e-9));
  EXPECT_TRUE(isNearly(scans[3].T_world_robot.pose, truth(3), 1e-9, 1e-9));
}

TEST_F(TrajectoryBuilderTest, AFailedScanMovesByOdometryAndTheNextOneRecovers)
{
  const auto scans = build(4, {{2, Oracle::kAlways}});
  EXPECT_FALSE(scans[2].isMatched());
  EXPECT_TRUE(isNearly(scans[2].T_world_robot.pose, truth(1) * measuredStep_, 1e-9, 1e-9));
  EXPECT_GT(scans[2].T_world_robot.covariance(0, 0), 10 * scans[1].T_world_robot.covariance(0, 0));
  EXPECT_TRUE(isNearly(scans[3].T_world_robot.pose, truth(3), 1e-9, 1e-9));
}

TEST_F(TrajectoryBuilderTest, AScanThatFailsAgainstTheReferenceIsMatchedAgainstTheScanBefore)
{
  const auto scans = build(4, {{2, 0}});
  ASSERT_EQ(scans[2].matches.size(), 2u);
  EXPECT_EQ(scans[2].matches[0].reference, 0u);
  EXPECT_EQ(scans[2].matches[1].reference, 1u);
  EXPECT_TRUE(scans[1].isReference);
  EXPECT_TRUE(isNearly(scans[2].T_world_robot.pose, truth(2), 1e-9, 1e-9));

  ReferenceOptions paper = sequential();
  paper.retryLastScan = false;
  EXPECT_EQ(build(4, {{2, 0}}, paper)[2].matches.size(), 1u);
}

TEST_F(TrajectoryBuilderTest, AWeakMatchIsReplacedByABetterOneAgainstTheScanBefore)
{
  Oracle weak;
  weak.scores[{2, 0}] = 0.7;
  const auto better = buildBy(weak, 3);
  EXPECT_EQ(better[2].decidingMatch()->reference, 1u);
  EXPECT_TRUE(better[1].isReference);

  weak.scores[{2, 1}] = 0.72;  // hardly more, and one more match on the way
  const auto asGood = buildBy(weak, 4);
  ASSERT_EQ(asGood[2].matches.size(), 2u);
  EXPECT_EQ(asGood[2].matches[0].reference, 0u) << "matches stand in the order they were tried";
  EXPECT_EQ(asGood[2].matches[1].reference, 1u);
  EXPECT_EQ(asGood[2].decidingMatch()->reference, 0u);
  EXPECT_FALSE(asGood[1].isReference);
  EXPECT_EQ(asGood[3].decidingMatch()->reference, 0u);
  EXPECT_TRUE(isNearly(asGood[3].T_world_robot.pose, truth(3), 1e-9, 1e-9));
}

TEST_F(TrajectoryBuilderTest, WhatFailsIsTriedWithAPriorAsWideAsWithoutOdometry)
{
  Oracle doubting;
  doubting.needsSigma_m[2] = OdometryOptions().unknownSigma_m;
  const auto scans = buildBy(doubting, 3);
  EXPECT_TRUE(scans[2].isMatched());
  EXPECT_TRUE(isNearly(scans[2].T_world_robot.pose, truth(2), 1e-9, 1e-9));
}

TEST_F(TrajectoryBuilderTest, AScanIsDeskewedByWhatTheRobotTurnsMeanwhile)
{
  auto oracle = std::make_unique<Oracle>();
  for (int i = 0; i < 2; ++i) oracle->T_world_sensor[i] = truth(i);
  TrajectoryBuilder builder(std::move(oracle), sequential(), OdometryOptions());
  Scan scan;
  scan.grid = BeamGrid::centered(kPi, 181);
  scan.range_m.assign(181, 1);
  scan.sweepDuration_s = 0.1;
  builder.add(scan, {}, std::nullopt);
  scan.stamp_s = 1;
  builder.add(scan, {}, Pose2{0, 0, degToRad(30)});  // in a second
  EXPECT_TRUE(builder.scans()[0].scan.grid == scan.grid);
  EXPECT_NEAR(builder.scans()[1].scan.grid.fieldOfView_rad(), kPi + degToRad(3), 1e-9);
}

TEST_F(TrajectoryBuilderTest, TheFirstScanIsTheOriginAndNeedsNoMatch)
{
  const auto scans = build(1, {});
  ASSERT_EQ(scans.size(), 1u);
  EXPECT_TRUE(isNearly(scans[0].T_world_robot.pose, {}, 0, 0));
  EXPECT_TRUE(scans[0].isReference);
  EXPECT_EQ(scans[0].decidingMatch(), nullptr);
  EXPECT_FALSE(scans[0].isMatched());
}

TEST_F(TrajectoryBuilderTest, WhereEveryMatchFailsTheLastOneTriedDecides)
{
  const auto scans = build(3, {{2, Oracle::kAlways}});
  ASSERT_GT(scans[2].matches.size(), 1u);
  EXPECT_EQ(scans[2].decidingMatch(), &scans[2].matches.back());
}

TEST_F(TrajectoryBuilderTest, AReferenceThatFailsAgainAndAgainIsGivenUp)
{
  std::map<double, double> fails;
  for (int i = 1; i < 6; ++i) fails[i] = 0;
  const auto scans = build(7, fails);
  EXPECT_TRUE(scans[5].isReference);
  EXPECT_TRUE(scans[6].isMatched());
  EXPECT_EQ(scans[6].decidingMatch()->reference, 5u);
}

TEST_F(TrajectoryBuilderTest, WithoutOdometryTheLastMotionIsAssumedAgain)
{
  const auto scans = build(4, {{3, Oracle::kAlways}}, {}, false);
  EXPECT_TRUE(isNearly(scans[3].T_world_robot.pose, truth(3), 1e-9, 1e-9));
  EXPECT_GT(scans[3].T_world_robot.covariance(0, 0), 0.05);
}

TEST_F(TrajectoryBuilderTest, WithoutOdometryABlindRobotIsTakenToStandAndItsReferenceStays)
{
  Oracle oracle;
  for (int stamp = 3; stamp <= 12; ++stamp) oracle.blind.insert(stamp);
  const auto scans = buildBy(oracle, 14, sequential(), false);
  EXPECT_TRUE(isNearly(scans[12].T_world_robot.pose, truth(3), 1e-9, 1e-9))
      << "it goes on for the first of ten scans";
  EXPECT_EQ(scans[12].matches.size(), 1u);
  EXPECT_EQ(scans[13].decidingMatch()->reference, 0u);
  EXPECT_TRUE(isNearly(scans[13].T_world_robot.pose, truth(13), 1e-9, 1e-9));
}

// The motion to scan 3 is measured, but it contradicts what was expected: scan 4, which fails, is
// not placed by it.
TEST_F(TrajectoryBuilderTest, AMatchThatContradictsItsGuessTellsNoSpeed)
{
  Oracle oracle;
  oracle.contradicts.insert(3);
  oracle.fails[4] = Oracle::kAlways;
  const auto scans = buildBy(oracle, 5, sequential(), false);
  EXPECT_TRUE(isNearly(scans[3].T_world_robot.pose, truth(3), 1e-9, 1e-9));
  EXPECT_TRUE(isNearly(scans[4].T_world_robot.pose, truth(3), 1e-9, 1e-9));
}

// ---- map ---------------------------------------------------------------------------------------

/** An oracle whose answers are all a little off, to the same side: what is matched scan by scan
 * drifts away. */
class BiasedOracle : public Oracle
{
 public:
  /** From this distance on it is 40 cm off against the first scan, and sure of itself. */
  double liesFrom_m = std::numeric_limits<double>::infinity();

  MatchResult match(const Scan& reference, const Scan& current, const Guess& guess) override
  {
    MatchResult result = Oracle::match(reference, current, guess);
    result.T_ref_cur = result.T_ref_cur * Pose2{0.001, 0, degToRad(0.02)};
    result.covariance = Eigen::Vector3d(1e-5, 1e-5, 1e-6).asDiagonal();
    if (reference.stamp_s == 0 && result.T_ref_cur.translation().norm() > liesFrom_m)
      result.T_ref_cur.x_m += 0.4;
    return result;
  }
};

/** Once around a block, back to the start and a little on.
 *
 *     +-------------------+ 14 m
 *     |  <-------------   |
 *     |  |  +-------+  ^  |
 *     |  |  |       |  |  |
 *     |  v  +-------+  |  |
 *     |  o------------>   |     o = (1.5, 1.5)
 *     +-------------------+ 0                                                               */
class MapLoop : public testing::Test
{
 protected:
  static constexpr double kSide_m = 11, kStep_m = 0.5, kBend_rad = degToRad(18);

  MapLoop()
  {
    walls_ = box({7, 7}, 14, 14);
    for (const Wall& wall : box({7, 7}, 8, 8)) walls_.push_back(wall);
    Pose2 pose{1.5, 1.5, 0};
    for (int side = 0; side < 4; ++side)
    {
      for (double way_m = 0; way_m < kSide_m; way_m += kStep_m) go(pose, {kStep_m, 0, 0});
      for (double turned_rad = 0; turned_rad < kPi / 2; turned_rad += kBend_rad)
        go(pose, {0, 0, kBend_rad});
    }
    for (int step = 0; step < 4; ++step) go(pose, {kStep_m, 0, 0});
  }

  void go(Pose2& pose, const Pose2& step)
  {
    truth_.push_back(pose);
    pose = pose * step;
  }

  TrajectoryBuilder driven(ReferenceChoice choice, int links = ReferenceOptions().mapLinks,
                           const BiasedOracle& tellsOf = {}) const
  {
    auto oracle = std::make_unique<BiasedOracle>(tellsOf);
    for (std::size_t i = 0; i < truth_.size(); ++i)
      oracle->T_world_sensor[static_cast<double>(i)] = truth_[i];
    ReferenceOptions options;
    options.choice = choice;
    options.mapLinks = links;
    options.loopPlaces = links;
    TrajectoryBuilder builder(std::move(oracle), options, OdometryOptions());
    for (std::size_t i = 0; i < truth_.size(); ++i)
    {
      Scan scan = castScan(walls_, truth_[i], BeamGrid::centered(2 * kPi, 360));
      scan.stamp_s = static_cast<double>(i);
      builder.add(scan, {},
                  i > 0 ? std::optional(truth_[i - 1].inverse() * truth_[i]) : std::nullopt);
    }
    return builder;
  }

  double error_m(const PosedScan& scan) const
  {
    const Pose2& truth = truth_[static_cast<std::size_t>(scan.stamp_s())];
    return ((truth_[0] * scan.T_world_robot.pose).translation() - truth.translation()).norm();
  }

  /** Mean over the scans that no reference is made of. */
  double meanErrorBetweenReferences_m(const TrajectoryBuilder& builder) const
  {
    double sum_m = 0;
    int scans = 0;
    for (const PosedScan& scan : builder.scans())
    {
      if (scan.isReference) continue;
      sum_m += error_m(scan);
      ++scans;
    }
    return sum_m / scans;
  }

  std::vector<Wall> walls_;
  std::vector<Pose2> truth_;
};

TEST_F(MapLoop, BackAtTheStartTheErrorIsThatOfTheStart)
{
  const TrajectoryBuilder sequential = driven(ReferenceChoice::Sequential);
  const TrajectoryBuilder map = driven(ReferenceChoice::Map);
  EXPECT_GT(error_m(sequential.scans().back()), 0.1);
  EXPECT_LT(error_m(map.scans().back()), 0.02);
}

TEST_F(MapLoop, KeyframesAreLinkedToTheLastFewOnly)
{
  const TrajectoryBuilder keyframe = driven(ReferenceChoice::Keyframe);
  std::vector<std::size_t> keyframes;
  std::size_t links = 0;
  for (std::size_t s = 0; s < keyframe.scans().size(); ++s)
  {
    for (const ReferenceMatch& link : keyframe.scans()[s].links)
    {
      const auto linked = std::find(keyframes.begin(), keyframes.end(), link.reference);
      EXPECT_LE(keyframes.end() - linked, ReferenceOptions().keyframeWindow);
      ++links;
    }
    if (keyframe.scans()[s].isReference) keyframes.push_back(s);
  }
  EXPECT_GT(links, 0U);
}

TEST_F(MapLoop, ItIsClosedByLinksToEarlierKeyframes)
{
  const TrajectoryBuilder map = driven(ReferenceChoice::Map);
  const auto& scans = map.scans();
  bool closed = false;
  for (std::size_t s = 0; s < scans.size(); ++s)
  {
    EXPECT_LE(scans[s].links.size(), static_cast<std::size_t>(ReferenceOptions().mapLinks));
    EXPECT_TRUE(scans[s].isReference || scans[s].links.empty());
    for (const ReferenceMatch& link : scans[s].links)
    {
      EXPECT_LT(link.reference, s);
      EXPECT_TRUE(scans[link.reference].isReference);
      closed = closed || (link.reference < 12 && s > truth_.size() / 2);
    }
  }
  EXPECT_TRUE(closed) << "no late keyframe is linked to an early one";
  EXPECT_TRUE(scans.front().links.empty());

  const TrajectoryBuilder unlinked = driven(ReferenceChoice::Map, 0);
  for (const PosedScan& scan : unlinked.scans()) EXPECT_TRUE(scan.links.empty());
}

TEST_F(MapLoop, AMatchThatNeitherTheMapNorAnotherMatchConfirmsLinksNothing)
{
  BiasedOracle liar;
  liar.liesFrom_m = 1.5;
  const TrajectoryBuilder map = driven(ReferenceChoice::Map, ReferenceOptions().mapLinks, liar);
  for (const PosedScan& scan : map.scans())
    for (const ReferenceMatch& link : scan.links)
    {
      const Pose2& current = truth_[static_cast<std::size_t>(scan.stamp_s())];
      EXPECT_TRUE(isNearly(link.T_ref_cur.pose, truth_[link.reference].inverse() * current, 0.01,
                           degToRad(0.1)));
    }
  EXPECT_LT(error_m(map.scans().back()), 0.02);
}

/** A robot in one room that drives ahead and back again, and on to the other side.
 *
 *     +----------------------------------------+     A, B, C: keyframes at 0 m, 1.2 m and -1.1 m.
 *     |                                        |     Scan 3 at 0.7 m is matched against B. Scan 4
 *     |     C   5   A   4   3     B            |     at 0.4 m is expected nearest to A, fails there
 *     +----------------------------------------+     and makes scan 3 a keyframe.               */
class ThereAndBack : public testing::Test
{
 protected:
  static constexpr std::size_t kA = 0, kB = 2, kLate = 3;

  ThereAndBack()
  {
    for (std::size_t i = 0; i < x_m_.size(); ++i)
      oracle_.T_world_sensor[static_cast<double>(i)] = {x_m_[i], 0, 0};
    oracle_.fails[4] = kA;
  }

  TrajectoryBuilder driven() const
  {
    TrajectoryBuilder builder(std::make_unique<Oracle>(oracle_), {}, OdometryOptions());
    for (std::size_t i = 0; i < x_m_.size(); ++i)
    {
      Scan scan = castScan(box({0, 0.5}, 8, 6), {x_m_[i], 0, 0}, BeamGrid::centered(2 * kPi, 360));
      scan.stamp_s = static_cast<double>(i);
      builder.add(scan, {},
                  i > 0 ? std::optional(Pose2{x_m_[i] - x_m_[i - 1], 0, 0}) : std::nullopt);
    }
    return builder;
  }

  const std::vector<double> x_m_{0, 0.6, 1.2, 0.7, 0.4, -0.4, -1.1};
  Oracle oracle_;
};

TEST_F(ThereAndBack, AScanThatBecomesAKeyframeLateIsMatchedAgainstItsReferenceOnce)
{
  const TrajectoryBuilder builder = driven();
  const PosedScan& late = builder.scans()[kLate];
  ASSERT_TRUE(late.isReference);
  EXPECT_EQ(late.decidingMatch()->reference, kB);
  for (const ReferenceMatch& link : late.links) EXPECT_NE(link.reference, kB);
}

TEST_F(ThereAndBack, APoseOfTheMapIsNoEvidenceForTheMap)
{
  // Two links lead from A to scan 3 over B, two others over C, and one joins B and C: half of the
  // error of one link remains. A link from A to scan 3 would repeat that error, for it can only
  // come from the map.
  oracle_.off_m[{kB, kA}] = 0.04;
  TrajectoryBuilder builder = driven();
  builder.optimise();
  EXPECT_NEAR(builder.scans()[kLate].T_world_robot.pose.x_m, x_m_[kLate] + 0.02, 1e-3);
}

TEST_F(MapLoop, AKeyframeJoinsWhereNoneIsNear)
{
  const TrajectoryBuilder map = driven(ReferenceChoice::Map);
  int keyframes = 0;
  for (const PosedScan& scan : map.scans()) keyframes += scan.isReference ? 1 : 0;
  // 44 m and 4 corners of 90 degrees, a metre or 30 degrees apart
  EXPECT_GT(keyframes, 40);
  EXPECT_LT(keyframes, 70);
}

TEST_F(MapLoop, OptimiseLeavesCovariancesAsTheyWere)
{
  TrajectoryBuilder map = driven(ReferenceChoice::Map);
  const auto before = map.scans();
  map.optimise();
  for (std::size_t s = 0; s < before.size(); ++s)
    EXPECT_EQ(map.scans()[s].T_world_robot.covariance, before[s].T_world_robot.covariance);
}

TEST_F(MapLoop, OptimiseMovesEarlierScansWithTheirReferences)
{
  TrajectoryBuilder map = driven(ReferenceChoice::Map);
  const double before_m = meanErrorBetweenReferences_m(map);
  map.optimise();
  EXPECT_LT(meanErrorBetweenReferences_m(map), 0.8 * before_m);
  for (const PosedScan& scan : map.scans())
  {
    if (scan.isReference) continue;
    const Pose2& anchor = map.scans()[scan.anchor].T_world_robot.pose;
    EXPECT_TRUE(isNearly(scan.T_world_robot.pose, anchor * scan.T_anchor_robot, 1e-12, 1e-12));
  }

  TrajectoryBuilder sequential = driven(ReferenceChoice::Sequential);
  const auto scans = sequential.scans();
  sequential.optimise();
  for (std::size_t s = 0; s < scans.size(); ++s)
    EXPECT_TRUE(isNearly(sequential.scans()[s].T_world_robot.pose, scans[s].T_world_robot.pose,
                         1e-12, 1e-12));
}
}  // namespace
}  // namespace psmks
