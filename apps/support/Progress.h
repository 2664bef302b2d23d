/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <string>

namespace psmks
{
/** A progress bar on stderr. Nothing is shown if stderr is not a terminal. */
class Progress
{
 public:
  explicit Progress(std::string task);

  /** Clears the line of the bar. */
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /** Shows a share of the work, 0 to 1. */
  void show(double share);

 private:
  std::string task_;
  bool terminal_;
  int shownPercent_ = -1;
};
}  // namespace psmks
