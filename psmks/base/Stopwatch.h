/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <chrono>

namespace psmks
{
/** Measures wall time in laps. */
class Stopwatch
{
 public:
  /** The time in seconds since the last call, or since the construction at the first call. */
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
