/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/psmks-benchmark/Progress.h>
#include <unistd.h>

#include <iostream>

namespace psmks
{
Progress::Progress(std::string task) : task_(std::move(task)), terminal_(isatty(STDERR_FILENO) != 0)
{
}

Progress::~Progress()
{
  if (terminal_) std::cerr << '\r' << std::string(task_.size() + 6, ' ') << '\r' << std::flush;
}

void Progress::show(double share)
{
  const int percent = static_cast<int>(100 * share);
  if (!terminal_ || percent == shownPercent_) return;
  shownPercent_ = percent;
  std::cerr << '\r' << task_ << ' ' << percent << " %" << std::flush;
}
}  // namespace psmks
