/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/matchers/PairMatcherRegistration.h>
#include <tests/support/ThrownText.h>
#include <tests/unit/matchers/PairMatcherContract.h>

#include <algorithm>
#include <set>

namespace psmks
{
INSTANTIATE_TEST_SUITE_P(WithoutMrpt, PairMatcherContract, testing::ValuesIn(pairMatcherNames()),
                         matcherTestName);

namespace
{
TEST(PairMatcher, AnUnknownNameIsRefusedWithTheKnownOnes)
{
  const std::string text = test::thrownText<OptionError>([] { makePairMatcher("csm"); });
  EXPECT_NE(text.find("'csm'"), std::string::npos);
  EXPECT_NE(text.find("psmks-paper"), std::string::npos);
}

TEST(PairMatcher, AMatchThatFailedKeepsTheGuessAndItsCovariance)
{
  const Eigen::Matrix3d covariance = Eigen::Vector3d(0.01, 0.02, 0.03).asDiagonal();
  const MatchResult measured = keptGuess(MatchStatus::NoImprovement, {{1, 2, 0.5}, covariance});
  EXPECT_EQ(measured.status, MatchStatus::NoImprovement);
  EXPECT_TRUE(isNearly(measured.T_ref_cur, {1, 2, 0.5}, 0, 0));
  EXPECT_EQ(measured.covariance, covariance);
  EXPECT_GT(keptGuess(MatchStatus::NoImprovement, {}).covariance.determinant(), 0);
}

// A room with noise of 3 cm, of which the scan says nothing. Whether it counts as noise of the
// scanner is the caller's to say.
TEST(PsmksPairMatcher, TheCallerSaysWhatIsKnownOfTheScannersNoise)
{
  std::mt19937 random(7);
  Scan noisy = castScan(squareRoom(), {}, BeamGrid::centered(2 * kPi, 720), 30, 0.03, random);
  noisy.rangeSigma_m = 0;
  const auto matcher = makePairMatcher("psmks");
  ScannerNoise quiet;
  for (int scans = 0; scans < 10; ++scans) quiet.add(false);
  const auto believed = matcher->prepare(noisy), doubted = matcher->prepare(noisy, quiet);
  EXPECT_TRUE(believed->showsMoreNoise());
  EXPECT_TRUE(doubted->showsMoreNoise());
  EXPECT_FALSE(quiet.isBelieved()) << "preparing a scan counts it nowhere";
  const MatchResult one = matcher->matchPrepared(*believed, *believed, {});
  const MatchResult other = matcher->matchPrepared(*doubted, *doubted, {});
  EXPECT_NE(one.covariance, other.covariance);
}

bool isKnown(const std::string& name)
{
  const auto names = pairMatcherNames();
  return std::find(names.begin(), names.end(), name) != names.end();
}

PairMatcherEntry guessNamed(const std::string& name)
{
  return {name, "made up", PairMatcherFamily::Guess, 1,
          [](const std::string&, const MatcherOptions&) { return makePairMatcher("guess"); }};
}

TEST(PairMatcherRegistration, NamesAreUniqueAndDescribedInOneLine)
{
  std::set<std::string> names;
  for (const auto& entry : pairMatcherEntries())
  {
    EXPECT_TRUE(names.insert(entry.name).second) << entry.name;
    EXPECT_FALSE(entry.description.empty()) << entry.name;
    EXPECT_EQ(entry.description.find('\n'), std::string::npos) << entry.name;
  }
}

TEST(PairMatcherRegistration, OursAreListedFirstAndTheGuessLast)
{
  const auto names = pairMatcherNames();
  EXPECT_EQ(names.front(), "psmks");
  EXPECT_EQ(names.back(), "guess");
}

TEST(PairMatcherRegistration, MakesAMatcherKnownForAsLongAsItLives)
{
  {
    const PairMatcherRegistration registration(guessNamed("passing"));
    EXPECT_TRUE(isKnown("passing"));
    EXPECT_EQ(pairMatcherNames().back(), "passing") << "the place in the family counts";
    EXPECT_EQ(makePairMatcher("passing")->name(), "guess");
  }
  EXPECT_FALSE(isKnown("passing"));
  EXPECT_THROW(makePairMatcher("passing"), OptionError);
}

TEST(PairMatcherRegistration, RefusesANameThatIsTaken)
{
  EXPECT_THROW(PairMatcherRegistration{guessNamed("psmks")}, std::logic_error);
  EXPECT_TRUE(isKnown("psmks")) << "the one that has the name keeps it";
}
}  // namespace
}  // namespace psmks
