/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <gtest/gtest.h>
#include <psmks/matchers/PairMatcherRegistration.h>
#include <tests/support/PoseMatcher.h>
#include <tests/support/Scenes.h>

#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <typeinfo>

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
