/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <gtest/gtest.h>
#include <psmks/matchers/PairMatcherRegistration.h>
#include <tests/support/BadInput.h>
#include <tests/support/PoseMatcher.h>
#include <tests/support/Scenes.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <typeinfo>
#include <utility>

namespace psmks
{
/** What PairMatcher.h promises of every matcher. A test program that links further matchers holds
 * them to it by one line:
 *
 *     INSTANTIATE_TEST_SUITE_P(Mine, PairMatcherContract, testing::ValuesIn(pairMatcherNames()),
 *                              matcherTestName);                                               */
class PairMatcherContract : public testing::TestWithParam<std::string>
{
 protected:
  const Pose2 T_ref_cur_{0.15, -0.1, degToRad(4)};
  const Guess guess_{{0.12, -0.08, degToRad(3)}, {}};
  const std::unique_ptr<PairMatcher> matcher_ = makePairMatcher(GetParam());

  static Scan roomScan(const Pose2& pose)
  {
    return castScan(officeRoom(), pose, BeamGrid::centered(degToRad(270), 541));
  }

  /** The matcher that returns its guess looks at no scan. */
  bool looksAtScans() const { return GetParam() != "guess"; }
};

/** A name of a test may hold letters, digits and underscores alone. */
inline std::string matcherTestName(const testing::TestParamInfo<std::string>& name)
{
  std::string text = name.param;
  std::replace(text.begin(), text.end(), '-', '_');
  return text;
}

inline void expectSame(const MatchResult& a, const MatchResult& b)
{
  EXPECT_EQ(a.status, b.status);
  EXPECT_TRUE(isNearly(a.T_ref_cur, b.T_ref_cur, 0, 0));
  EXPECT_EQ(a.covariance, b.covariance);
  EXPECT_EQ(a.score, b.score);
}

TEST_P(PairMatcherContract, HasTheNameItWasMadeBy) { EXPECT_EQ(matcher_->name(), GetParam()); }

TEST_P(PairMatcherContract, FindsASmallMotionInARoom)
{
  const MatchResult result = matcher_->match(roomScan({}), roomScan(T_ref_cur_), guess_);
  EXPECT_TRUE(result.usable());
  const double tolerance_m = looksAtScans() ? 0.02 : 0.04;
  const double tolerance_rad = looksAtScans() ? degToRad(0.7) : degToRad(1.1);
  EXPECT_TRUE(isNearly(result.T_ref_cur, T_ref_cur_, tolerance_m, tolerance_rad));
  EXPECT_GT(result.covariance.determinant(), 0);
}

TEST_P(PairMatcherContract, MatchesPreparedScansAsRawOnes)
{
  const Scan reference = roomScan({}), current = roomScan(T_ref_cur_);
  const auto preparedRef = matcher_->prepare(reference), preparedCur = matcher_->prepare(current);
  const MatchResult raw = matcher_->match(reference, current, guess_);
  expectSame(matcher_->matchPrepared(*preparedRef, *preparedCur, guess_), raw);
}

TEST_P(PairMatcherContract, APreparedScanServesAsReferenceAndAsCurrentScan)
{
  const Scan here = roomScan({}), there = roomScan(T_ref_cur_);
  const auto preparedHere = matcher_->prepare(here), preparedThere = matcher_->prepare(there);
  const MatchResult back = matcher_->matchPrepared(*preparedThere, *preparedHere, {});
  expectSame(back, matcher_->match(there, here, {}));
}

// Between two equal calls the matcher sees a noisy scan and one without returns.
TEST_P(PairMatcherContract, ResultsDoNotDependOnTheCallsBefore)
{
  const Scan reference = roomScan({}), current = roomScan(T_ref_cur_);
  std::mt19937 random(5);
  Scan noisy = castScan(officeRoom(), T_ref_cur_, BeamGrid::centered(kPi, 181), 30, 0.06, random);
  noisy.rangeSigma_m = 0;  // the matcher has to find out
  const MatchResult before = matcher_->match(reference, current, guess_);
  for (int i = 0; i < 3; ++i) matcher_->match(noisy, noisy, {});
  matcher_->match(Scan(), current, guess_);
  expectSame(matcher_->match(reference, current, guess_), before);

  const auto preparedRef = matcher_->prepare(reference), preparedCur = matcher_->prepare(current);
  expectSame(matcher_->matchPrepared(*preparedRef, *preparedCur, guess_), before);
}

TEST_P(PairMatcherContract, ScansWithoutReturnsAreAFailureThatKeepsTheGuess)
{
  if (!looksAtScans()) return;
  for (const bool referenceIsEmpty : {true, false})
  {
    const Scan reference = referenceIsEmpty ? Scan() : roomScan({});
    const Scan current = referenceIsEmpty ? roomScan({}) : Scan();
    const MatchResult result = matcher_->match(reference, current, guess_);
    EXPECT_EQ(result.status, MatchStatus::InvalidInput);
    EXPECT_TRUE(isNearly(result.T_ref_cur, guess_.T_ref_cur, 0, 0));
    EXPECT_GT(result.covariance.determinant(), 0);
  }
}

TEST_P(PairMatcherContract, AGuessThatIsNotFiniteIsAFailure)
{
  if (!looksAtScans()) return;
  const Guess lost{{std::numeric_limits<double>::quiet_NaN(), 0, 0}, {}};
  const MatchResult result = matcher_->match(roomScan({}), roomScan({}), lost);
  EXPECT_EQ(result.status, MatchStatus::InvalidInput);
  EXPECT_FALSE(result.usable());
}

// Priors that nobody has, and some that are none, in a room and before one wall.
TEST_P(PairMatcherContract, CovariancesAreValidForEveryPrior)
{
  const Scan room = roomScan({}), moved = roomScan(T_ref_cur_);
  Scan wall = room;
  for (std::size_t ray = 0; ray < wall.range_m.size(); ++ray)
    if (ray < 200 || ray > 300) wall.range_m[ray] = 0;
  for (const double exponent : {-320.0, -200.0, -20.0, -9.0, 9.0, 18.0, 200.0, 307.0})
    for (const Scan* reference : {&room, static_cast<const Scan*>(&wall)})
    {
      Guess guess = guess_;
      guess.covariance = Eigen::Vector3d(std::pow(10, exponent), 1, std::pow(10, exponent / 2))
                             .asDiagonal()
                             .toDenseMatrix();
      const Eigen::Matrix3d covariance = matcher_->match(*reference, moved, guess).covariance;
      EXPECT_TRUE(covariance.allFinite()) << exponent << '\n' << covariance;
      EXPECT_EQ(covariance, covariance.transpose()) << exponent;
      EXPECT_EQ(covariance.llt().info(), Eigen::Success) << exponent << '\n' << covariance;
    }
  Guess lopsided = guess_;
  lopsided.covariance =
      Eigen::Matrix3d::Ones() + Eigen::Vector3d(0, 0, 9) * Eigen::RowVector3d(1, 0, 0);
  EXPECT_EQ(matcher_->match(room, moved, lopsided).covariance.llt().info(), Eigen::Success);
}

TEST_P(PairMatcherContract, BadInputNeitherThrowsNorGivesInvalidCovariances)
{
  test::RandomNumbers random(63);
  SCOPED_TRACE(random.seedText());
  test::BadScans scans(random);
  Scan reference = scans.next();
  for (int i = 0; i < 300; ++i)
  {
    Scan current = scans.next();
    const MatchResult result = matcher_->match(reference, current, test::anyGuess(random));
    EXPECT_TRUE(result.T_ref_cur.isFinite()) << i;
    EXPECT_TRUE(result.covariance.allFinite()) << i << '\n' << result.covariance;
    EXPECT_EQ(result.covariance, result.covariance.transpose()) << i;
    EXPECT_EQ(result.covariance.llt().info(), Eigen::Success) << i << '\n' << result.covariance;
    reference = std::move(current);
  }
}

/** What no matcher has prepared. */
class ForeignScan : public PreparedScan
{
};

TEST_P(PairMatcherContract, AScanThatAnotherKindOfMatcherPreparedIsRefused)
{
  const auto own = matcher_->prepare(roomScan({}));
  EXPECT_THROW(matcher_->matchPrepared(*own, ForeignScan(), guess_), std::bad_cast);
}
}  // namespace psmks
