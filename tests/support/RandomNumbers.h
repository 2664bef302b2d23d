/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <random>
#include <string>

namespace psmks::test
{
/** Repeatable random numbers: a failing test that says SCOPED_TRACE(random.seedText()) prints the
 *  seed it ran with. */
class RandomNumbers
{
 public:
  explicit RandomNumbers(unsigned seed) : seed_(seed), engine_(seed) {}

  double uniform(double min, double max)
  {
    return std::uniform_real_distribution<double>(min, max)(engine_);
  }

  double normal(double sigma) { return std::normal_distribution<double>(0, sigma)(engine_); }

  /** A whole number, both ends included. */
  int integer(int min, int max) { return std::uniform_int_distribution<int>(min, max)(engine_); }

  std::string seedText() const { return "seed " + std::to_string(seed_); }

 private:
  unsigned seed_;
  std::mt19937_64 engine_;
};
}  // namespace psmks::test
