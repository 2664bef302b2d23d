/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <apps/support/Progress.h>
#include <unistd.h>

#include <iostream>

namespace psmks
{
namespace
{
constexpr int kBarWidth = 40;              // in characters
constexpr std::size_t kSurroundings = 10;  // characters of the line besides the task and the bar
}  // namespace

Progress::Progress(std::string task) : task_(std::move(task)), terminal_(isatty(STDERR_FILENO) != 0)
{
}

Progress::~Progress()
{
  if (terminal_)
    std::cerr << '\r' << std::string(task_.size() + kBarWidth + kSurroundings, ' ') << '\r'
              << std::flush;
}

void Progress::show(double share)
{
  const int percent = static_cast<int>(100 * share);
  if (!terminal_ || percent == shownPercent_) return;
  shownPercent_ = percent;
  const auto full = static_cast<std::size_t>(kBarWidth * share);
  std::cerr << '\r' << task_ << " [" << std::string(full, '#') << std::string(kBarWidth - full, ' ')
            << "] " << percent << " %" << std::flush;
}
}  // namespace psmks
