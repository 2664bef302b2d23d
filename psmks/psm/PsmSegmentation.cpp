/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/psm/PsmSegmentation.h>

#include <cmath>

namespace psmks
{
namespace
{
class Segmenter
{
 public:
  Segmenter(double break_m, PsmScan& scan) : break_m_(break_m), scan_(scan) {}

  void run()
  {
    const int rays = scan_.rays();
    scan_.segment.assign(static_cast<std::size_t>(rays), PsmScan::kNoSurface);
    const int first = scan_.grid.closed() ? afterGreatestJump() : 0;
    for (int step = 0; step < rays; ++step)
    {
      const int i = scan_.grid.neighbour(first, step);
      const int before = step > 0 ? scan_.grid.neighbour(i, -1) : kNone;
      place(i, before, step > 1 ? scan_.grid.neighbour(i, -2) : kNone);
    }
    if (scan_.grid.closed() && rays > 0) cutEndOfSpiral(scan_.grid.neighbour(first, -1), first);
  }

 private:
  /** Stands for no ray. Unit: index. Definition: no index is negative. */
  static constexpr int kNone = -1;

  double jump_m(int i, int before) const { return std::abs(scan_.range(i) - scan_.range(before)); }

  /** The ray to start from: the one after a ray without a reading, else the one after the greatest
   * jump of the range. */
  int afterGreatestJump() const
  {
    int first = 0;
    double greatest_m = -1;
    for (int i = 0; i < scan_.rays(); ++i)
    {
      const int before = scan_.grid.neighbour(i, -1);
      if (!scan_.isGood(before)) return i;
      if (scan_.isGood(i) && jump_m(i, before) > greatest_m)
      {
        greatest_m = jump_m(i, before);
        first = i;
      }
    }
    return first;
  }

  /** Assigns ray i to a segment. It stays without a surface until another ray joins it. */
  void place(int i, int before, int beforeThat)
  {
    if (before == kNone || !scan_.isGood(i) || !scan_.isGood(before)) return;
    if (jump_m(i, before) < break_m_)
      join(i, before);
    else if (beforeThat != kNone && scan_.isGood(beforeThat) && continues(i, before, beforeThat))
    {
      if (isOnNoSurface(before) && isOnNoSurface(beforeThat)) join(before, beforeThat);
      if (scan_.sameSurface(before, beforeThat)) join(i, before);
    }
  }

  bool isOnNoSurface(int i) const { return scan_.segmentOf(i) == PsmScan::kNoSurface; }

  bool continues(int i, int before, int beforeThat) const
  {
    const double expected_m = 2 * scan_.range(before) - scan_.range(beforeThat);
    return std::abs(scan_.range(i) - expected_m) < break_m_;
  }

  void join(int i, int before)
  {
    int& segment = scan_.segment[static_cast<std::size_t>(before)];
    if (segment == PsmScan::kNoSurface) segment = ++segments_;
    scan_.segment[static_cast<std::size_t>(i)] = segment;
  }

  /** If one surface goes all the way round but ends in a jump of the range, its last ray is taken
   * off. */
  void cutEndOfSpiral(int last, int first)
  {
    if (scan_.sameSurface(last, first) && jump_m(first, last) >= break_m_)
      scan_.segment[static_cast<std::size_t>(last)] = PsmScan::kNoSurface;
  }

  double break_m_;
  PsmScan& scan_;
  int segments_ = 0;
};
}  // namespace

void segmentPsmScan(double break_m, PsmScan& scan) { Segmenter(break_m, scan).run(); }
}  // namespace psmks
