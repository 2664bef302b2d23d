/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/mrpt/LendingPool.h>

#include <set>
#include <thread>

namespace psmks::test
{
using Pool = LendingPool<int>;

TEST(LendingPool, LendsAnObjectAgainAfterItCameBack)
{
  Pool pool;
  int* first = nullptr;
  {
    Pool::Loan loan(pool);
    first = &*loan;
    *loan = 7;
  }
  Pool::Loan again(pool);
  EXPECT_EQ(&*again, first);
  EXPECT_EQ(*again, 7);
}

TEST(LendingPool, LendsEachBorrowerItsOwnObject)
{
  Pool pool;
  Pool::Loan a(pool), b(pool), c(pool);
  EXPECT_EQ((std::set<int*>{&*a, &*b, &*c}).size(), 3U);
}

TEST(LendingPool, SharesNothingWithACopy)
{
  Pool pool;
  {
    Pool::Loan loan(pool);
    *loan = 7;
  }
  Pool copy(pool);
  Pool::Loan loan(copy);
  EXPECT_EQ(*loan, 0);
}

TEST(LendingPool, ServesThreads)
{
  constexpr int kThreads = 4, kRounds = 2000;
  Pool pool;
  std::vector<std::thread> threads;
  for (int t = 0; t < kThreads; ++t)
    threads.emplace_back(
        [&]
        {
          for (int i = 0; i < kRounds; ++i) ++*Pool::Loan(pool);
        });
  for (std::thread& thread : threads) thread.join();
  std::vector<std::unique_ptr<Pool::Loan>> all;
  int sum = 0;
  for (int t = 0; t < kThreads; ++t) sum += **all.emplace_back(std::make_unique<Pool::Loan>(pool));
  EXPECT_EQ(sum, kThreads * kRounds);
}
}  // namespace psmks::test
