/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <random>
#include <string>

namespace psmks::test
{
/** Repeatable random numbers. A test that calls SCOPED_TRACE(random.seedText()) prints its seed if
 * it fails. */
class RandomNumbers
{
 public:
  explicit RandomNumbers(unsigned seed) : seed_(seed), engine_(seed) {}

  double uniform(double min, double max)
  {
    return std::uniform_real_distribution<double>(min, max)(engine_);
  }

  double normal(double sigma) { return std::normal_distribution<double>(0, sigma)(engine_); }

  /** A whole number between min and max, both included. */
  int integer(int min, int max) { return std::uniform_int_distribution<int>(min, max)(engine_); }

  std::string seedText() const { return "seed " + std::to_string(seed_); }

 private:
  unsigned seed_;
  std::mt19937_64 engine_;
};
}  // namespace psmks::test
