/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <gtest/gtest.h>
#include <psmks/logs/GuardedProcess.h>

#include <csignal>
#include <cstring>
#include <stdexcept>
#include <vector>

namespace psmks
{
namespace
{
constexpr std::size_t kMegabyte = 1 << 20;

TEST(GuardedProcess, WorkThatIsFineEndsWellAndChangesNothingHere)
{
  int done = 0;
  EXPECT_TRUE(endsWell(kMegabyte, [&done] { done = 1; }));
  EXPECT_EQ(done, 0);
}

TEST(GuardedProcess, ACrashAndAnExceptionReachNobody)
{
  EXPECT_FALSE(endsWell(kMegabyte, [] { raise(SIGSEGV); }));
  EXPECT_FALSE(endsWell(kMegabyte, [] { throw std::runtime_error("no"); }));
}

TEST(GuardedProcess, MemoryIsLimited)
{
  const auto take = [](std::size_t bytes)
  {
    return [bytes]
    {
      std::vector<char> memory(bytes);
      std::memset(memory.data(), 1, bytes);
      if (memory[bytes / 2] != 1) throw std::runtime_error("not there");
    };
  };
  EXPECT_TRUE(endsWell(64 * kMegabyte, take(16 * kMegabyte)));
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && !defined(__clang__)
  EXPECT_FALSE(endsWell(64 * kMegabyte, take(512 * kMegabyte)));
#endif
}
}  // namespace
}  // namespace psmks
