/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/core/LineSums.h>
#include <psmks/core/SegmentationOptions.h>
#include <psmks/core/SegmentedScan.h>

#include <vector>

namespace psmks
{
/** A line in the making: a run of rays, most of which belong to it. */
struct LineRun
{
  int first = 0, last = 0;  //!< positions, see LineRuns
  LineSums sums;            //!< of the rays that belong to it
};

/** The lines of a scan while they are made: grown, contested and merged.
 *
 * Rays are counted by position: 0 is the first ray of an open scan, and the ray at the strongest
 * break of a closed one, so that no wall is cut by the seam. A ray that belongs to run k carries
 * the mark k in `scan.segmentOfRay`; runs stand in the order of their positions and do not overlap.
 */
class LineRuns
{
 public:
  /** @param scan cleaned, with its range sigma settled and no ray marked
   *  @param inverseRange_1_m 1/r of the valid rays
   *  @param runs storage; what it held is replaced */
  LineRuns(const SegmentationOptions& options, const std::vector<double>& inverseRange_1_m,
           SegmentedScan& scan, std::vector<LineRun>& runs);

  /** Lines grown from seeds by the filter the options choose (paper, section 2: Kalman
   *  Segmentation). */
  void grow();

  /** Rays between two touching lines go to the line that explains them: the corner is put where the
   *  sum of both chi2 is smallest. */
  void contestCorners();

  /** Touching lines become one where a common line raises chi2 by less than chance allows. */
  void mergeCollinear();

  const std::vector<LineRun>& runs() const { return runs_; }

  /** Cuts a run in two where that lowers chi2 by more than chance does over all cuts: what looked
   * like one line ray by ray may be two that are a few millimetres apart. False where it is one
   * line.
   *  @param mark of the run's rays; both parts keep it */
  bool cut(const LineRun& run, int mark, LineRun& left, LineRun& right) const;

  /** Ray index of a position. */
  int ray(int position) const
  {
    const int i = start_ + position;
    return i < rays_ ? i : i - rays_;
  }

 private:
  template <class Filter>
  void growAll(const Filter& fresh);
  template <class Filter>
  int growSide(Filter& filter, LineRun& run, int index, int from, int step, int limit);
  template <class Filter>
  void dropOutlyingStart(const Filter& grown, LineRun& run);
  bool seedAt(int position, LineSums& sums) const;

  void contest(int left, int right);
  void settleEnds(LineRun& left, LineRun& right, int leftIndex, int rightIndex, int begin, int end);
  bool collinear(const LineRun& left, const LineRun& right) const;
  void reassign(int firstPosition, int lastPosition, int from, int to);

  std::size_t at(int position) const { return static_cast<std::size_t>(ray(position)); }
  bool valid(int position) const { return scan_.valid[at(position)] != 0; }
  int& mark(int position) { return scan_.segmentOfRay[at(position)]; }
  int mark(int position) const { return scan_.segmentOfRay[at(position)]; }
  MeasuredRay measured(int position) const
  {
    const std::size_t i = at(position);
    return {scan_.grid.cosines()[i], scan_.grid.sines()[i], scan_.range_m[i], inverseRange_1_m_[i]};
  }
  double chi2(const LineSums& sums) const;

  const SegmentationOptions& options_;
  const std::vector<double>& inverseRange_1_m_;
  SegmentedScan& scan_;
  std::vector<LineRun>& runs_;
  int rays_;
  int start_;
  double variance_m2_;
};
}  // namespace psmks
