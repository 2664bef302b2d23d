/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <tests/laws/AllocationCount.h>
#include <tests/laws/Schemes.h>

#include <memory>

namespace psmks
{
namespace
{
class Allocation : public SchemeLaw
{
};

INSTANTIATE_TEST_SUITE_P(Schemes, Allocation, testing::ValuesIn(bothSchemes()), schemeName);
}  // namespace

TEST(AllocationCount, Counts)
{
  const std::size_t before = allocationCount();
  const auto number = std::make_unique<int>(7);
  EXPECT_EQ(*number, 7);
  EXPECT_EQ(allocationCount(), before + 1);
}

TEST_P(Allocation, AMatchAllocatesNothingAfterTheFirst)
{
  std::vector<ScanPair> pairs;
  for (int i = 0; i < kPairs; ++i) pairs.push_back(randomPair(kHalfCircle));
  for (const ScanPair& pair : pairs) match(pair.reference, pair.current);
  for (const ScanPair& pair : pairs)
  {
    const std::size_t before = allocationCount();
    const MatchResult result = match(pair.reference, pair.current);
    const std::size_t allocated = allocationCount() - before;
    EXPECT_EQ(allocated, 0u) << result.report();
  }
}

TEST_P(Allocation, ASearchFarFromTheGuessAllocatesNothingEither)
{
  const ScanPair pair = randomPair(kFullCircle);
  const Guess off{{0.6, -0.4, degToRad(35)}, {}};
  match(pair.reference, pair.current, off);
  const std::size_t before = allocationCount();
  match(pair.reference, pair.current, off);
  EXPECT_EQ(allocationCount() - before, 0u);
}

TEST_P(Allocation, SegmentationAllocatesNothingAfterTheFirst)
{
  const ScanPair pair = randomPair(kFullCircle);
  SegmentedScan result;
  matcher_.segment(pair.reference, workspace_, result);
  const std::size_t before = allocationCount();
  matcher_.segment(pair.reference, workspace_, result);
  EXPECT_EQ(allocationCount() - before, 0u);
}
}  // namespace psmks
