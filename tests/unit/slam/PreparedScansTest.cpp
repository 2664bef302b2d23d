/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/slam/PreparedScans.h>

#include <vector>

namespace psmks
{
namespace
{
/** Prepares a scan by noting its stamp and whether its noise was believed; a scan with a negative
 * stamp shows more noise than stated. */
class NotingMatcher : public PairMatcher
{
 public:
  struct Note
  {
    double stamp_s;
    bool believed;
  };

  std::string name() const override { return "noting"; }
  MatchResult match(const Scan&, const Scan&, const Guess&) override { return {}; }
  std::unique_ptr<PreparedScan> prepare(const Scan& scan, const ScannerNoise& scanner) override
  {
    ++prepared;
    const Note note{scan.stamp_s, scanner.isBelieved()};
    return std::make_unique<PreparedAs<Note>>(note, scan.stamp_s < 0);
  }

  int prepared = 0;
};

class PreparedScansTest : public testing::Test
{
 protected:
  static constexpr std::size_t kCapacity = 3;

  NotingMatcher::Note find(std::size_t index)
  {
    Scan scan;
    const auto stamp_s = static_cast<double>(index + 1);
    scan.stamp_s = noisy_ ? -stamp_s : stamp_s;
    return dataOf<NotingMatcher::Note>(*scans_.find(index, scan));
  }

  NotingMatcher matcher_;
  PreparedScans scans_{matcher_, kCapacity};
  bool noisy_ = false;
};
}  // namespace

TEST_F(PreparedScansTest, AScanIsPreparedOnce)
{
  for (int time = 0; time < 4; ++time)
  {
    EXPECT_EQ(find(0).stamp_s, 1);
    EXPECT_EQ(find(1).stamp_s, 2);
  }
  EXPECT_EQ(matcher_.prepared, 2);
}

TEST_F(PreparedScansTest, BeyondTheCapacityTheOneUsedLongestAgoIsPreparedAnew)
{
  for (const std::size_t index : {0, 1, 2}) find(index);
  find(0);  // 1 is now the one that was used longest ago
  find(3);
  EXPECT_EQ(matcher_.prepared, 4);
  for (const std::size_t kept : {0, 2, 3}) find(kept);
  EXPECT_EQ(matcher_.prepared, 4);
  EXPECT_EQ(find(1).stamp_s, 2);
  EXPECT_EQ(matcher_.prepared, 5);
}

TEST_F(PreparedScansTest, AScanInUseOutlivesItsPlace)
{
  Scan scan;
  scan.stamp_s = 1;
  const auto held = scans_.find(0, scan);
  for (const std::size_t index : {1, 2, 3, 4}) find(index);
  EXPECT_EQ(dataOf<NotingMatcher::Note>(*held).stamp_s, 1);
}

TEST_F(PreparedScansTest, EveryScanCountsOnceInTheNoiseOfTheScanner)
{
  find(0);  // quiet
  noisy_ = true;
  for (int time = 0; time < 10; ++time) find(1);
  EXPECT_FALSE(scans_.scanner().isBelieved()) << "one of two";
  for (const std::size_t index : {2, 3}) find(index);
  EXPECT_TRUE(scans_.scanner().isBelieved()) << "three of four";
  for (std::size_t index = 4; index < 9; ++index) find(index);
  find(1);  // was forgotten meanwhile
  noisy_ = false;
  for (const std::size_t index : {9, 10}) find(index);
  EXPECT_FALSE(scans_.scanner().isBelieved()) << "eight of eleven";
}

TEST_F(PreparedScansTest, ANoisyScanIsPreparedAnewWhereTheScannerTurnsOutToBeQuiet)
{
  noisy_ = true;
  EXPECT_TRUE(find(0).believed) << "nothing is known of the scanner yet";
  noisy_ = false;
  find(1);
  noisy_ = true;
  EXPECT_FALSE(find(0).believed);
}

TEST_F(PreparedScansTest, AQuietScanIsTheSameWhateverTheScannerTurnsOutToBe)
{
  find(0);
  noisy_ = true;
  for (const std::size_t index : {1, 2}) find(index);
  noisy_ = false;
  const int prepared = matcher_.prepared;
  find(0);
  EXPECT_EQ(matcher_.prepared, prepared);
}
}  // namespace psmks
