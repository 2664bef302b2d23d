/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <chrono>

namespace psmks
{
/** Wall time since its making or the last lap. */
class Stopwatch
{
 public:
  double lap_s()
  {
    const auto now = Clock::now();
    const double elapsed_s = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    return elapsed_s;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_ = Clock::now();
};
}  // namespace psmks
