/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <string>

namespace psmks
{
/** A bar on stderr that says how far the work is; silent where stderr is no terminal. */
class Progress
{
 public:
  explicit Progress(std::string task);

  /** Clears the line. */
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /** @param share 0 to 1 */
  void show(double share);

 private:
  std::string task_;
  bool terminal_;
  int shownPercent_ = -1;
};
}  // namespace psmks
