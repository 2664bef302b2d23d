/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/matchers/PairMatcher.h>
#include <psmks/slam/LoopSearch.h>
#include <tests/support/PoseMatcher.h>
#include <tests/support/Scenes.h>

#include <Eigen/LU>
#include <random>

namespace psmks
{
namespace
{
/** A corridor along x, of 3 m, the left wall of which has bays with slanted sides at these places.
 *
 *         /--\     /--\                    keyframes 1 m apart that look to the right; the robot
 *     ---/    \---/    \--------            comes back and looks to the left. The scanner reaches
 *      0> 1> 2> 3> ...  <x     16>         8 m.
 *     ---------------------------                                                             */
std::vector<Wall> corridorWith(const std::vector<double>& bays_m)
{
  constexpr double kFrom_m = -20, kTo_m = 40, kSide_m = 1.5, kDeep_m = 2.5, kHalf_m = 1,
                   kTop_m = 0.4;
  std::vector<Wall> walls{{{kFrom_m, -kSide_m}, {kTo_m, -kSide_m}}};
  Eigen::Vector2d last(kFrom_m, kSide_m);
  const auto goTo = [&](double x_m, double y_m)
  {
    walls.push_back({last, {x_m, y_m}});
    last = {x_m, y_m};
  };
  for (const double x_m : bays_m)
  {
    goTo(x_m - kHalf_m, kSide_m);
    goTo(x_m - kTop_m, kDeep_m);
    goTo(x_m + kTop_m, kDeep_m);
    goTo(x_m + kHalf_m, kSide_m);
  }
  goTo(kTo_m, kSide_m);
  return walls;
}

class LoopSearchTest : public testing::Test
{
 protected:
  void driveThere(const std::vector<Wall>& walls)
  {
    walls_ = walls;
    map_.add(scans_, addScan({0, 0, 0}), {});
    for (int x = 1; x <= 16; ++x)
    {
      const std::size_t index = addScan({static_cast<double>(x), 0, 0});
      map_.add(scans_, index, {linkFrom(index - 1, {1, 0, 0})});
    }
  }

  std::size_t addScan(const Pose2& pose)
  {
    PosedScan posed;
    posed.scan = castScan(walls_, pose, BeamGrid::centered(kPi, 361), 8, 0.01, rng_);
    posed.scan.rangeSigma_m = 0.01;
    posed.scan.maxRange_m = 8;
    posed.T_world_robot.pose = pose;
    scans_.push_back(posed);
    return scans_.size() - 1;
  }

  static ReferenceMatch linkFrom(std::size_t reference, const Pose2& T_ref_cur)
  {
    ReferenceMatch link;
    link.reference = reference;
    link.T_ref_cur = {T_ref_cur, Eigen::Vector3d(1e-6, 1e-6, 1e-8).asDiagonal()};
    link.information = link.T_ref_cur.covariance.inverse();
    return link;
  }

  /** What is found for a scan at a pose that is said to be elsewhere, with this uncertainty. */
  std::vector<ReferenceMatch> linksOf(const Pose2& truth, const Pose2& said, double sigma_m,
                                      double sigma_rad)
  {
    const std::size_t index = addScan(truth);
    scans_[index].T_world_robot.pose = said;
    const UncertainPose T_last_cur{
        scans_[16].T_world_robot.pose.inverse() * said,
        Eigen::Vector3d(sigma_m, sigma_m, sigma_rad).cwiseAbs2().asDiagonal()};
    map_.standAt(16, T_last_cur);
    return search_.links(scans_, index, 16, T_last_cur, map_, matcher_);
  }

  ReferenceOptions options_;
  std::mt19937 rng_{7};
  std::vector<Wall> walls_;
  std::vector<PosedScan> scans_;
  KeyframeMap map_{ReferencePolicy(options_)};
  PosedScanMatcher matcher_{makePairMatcher("psmks")};
  LoopSearch search_{ReferencePolicy(options_)};
};

const std::vector<double> kUneven_m{-6, -3.5, 0.5, 3.1, 8.3, 10.7, 15.2, 18.8};
}  // namespace

TEST_F(LoopSearchTest, AWayBackInTheOppositeDirectionIsRecognised)
{
  driveThere(corridorWith(kUneven_m));
  const Pose2 truth{8, 0.2, kPi};
  const auto links = linksOf(truth, {9.1, -0.3, degToRad(172)}, 0.6, degToRad(6));
  ASSERT_FALSE(links.empty());
  for (const ReferenceMatch& link : links)
    EXPECT_TRUE(isNearly(scans_[link.reference].T_world_robot.pose * link.T_ref_cur.pose, truth,
                         0.05, degToRad(0.5)));
}

TEST_F(LoopSearchTest, InTheSameDirectionKeyframesThatSawTheSameAreTheLinks)
{
  driveThere(corridorWith(kUneven_m));
  const Pose2 truth{7.4, 0.2, degToRad(4)};
  const auto links = linksOf(truth, {8.2, -0.3, 0}, 0.5, degToRad(5));
  ASSERT_FALSE(links.empty());
  for (const ReferenceMatch& link : links)
  {
    EXPECT_TRUE(isNearly(scans_[link.reference].T_world_robot.pose * link.T_ref_cur.pose, truth,
                         0.02, degToRad(0.3)));
    EXPECT_LT(link.T_ref_cur.covariance(0, 0), 0.02 * 0.02) << "a match of scans, not of views";
  }
}

// Bays every 3 m: the scan fits as well 3 m farther on, which the graph does not exclude.
TEST_F(LoopSearchTest, WhereTwoPlacesLookAlikeNoneIsTaken)
{
  std::vector<double> even_m;
  for (double x_m = -18; x_m < 38; x_m += 3) even_m.push_back(x_m);
  driveThere(corridorWith(even_m));
  EXPECT_TRUE(linksOf({8, 0, 0}, {9.5, 0, 0}, 1.5, degToRad(2)).empty());
}

TEST_F(LoopSearchTest, WithinTheKnownNothingIsSearched)
{
  driveThere(corridorWith(kUneven_m));
  EXPECT_TRUE(linksOf({8, 0, 0}, {8.01, 0, 0}, 0.01, degToRad(0.1)).empty());
}

TEST_F(LoopSearchTest, WithNoPlacesAllowedNothingIsSearched)
{
  options_.loopPlaces = 0;
  search_ = LoopSearch(ReferencePolicy(options_));
  driveThere(corridorWith(kUneven_m));
  EXPECT_TRUE(linksOf({8, 0.2, kPi}, {9.1, -0.3, degToRad(172)}, 0.6, degToRad(6)).empty());
}

// One place a keyframe is allowed: the first ones that are asked show something else, and the next
// keyframe asks others.
TEST_F(LoopSearchTest, WhatWasSearchedInVainComesAfterTheRest)
{
  options_.loopPlaces = 1;
  search_ = LoopSearch(ReferencePolicy(options_));
  driveThere(corridorWith(kUneven_m));
  bool isFound = false;
  for (int i = 0; i < 8 && !isFound; ++i)
    isFound = !linksOf({2, 0.2, kPi}, {12, 0, kPi}, 4, degToRad(4)).empty();
  EXPECT_TRUE(isFound);
}
}  // namespace psmks
