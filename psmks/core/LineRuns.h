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
   *  @param runs storage; what it held is replaced */
  LineRuns(const SegmentationOptions& options, SegmentedScan& scan, std::vector<LineRun>& runs);

  /** Lines grown from seeds by the filter the options choose (paper, section 2: Kalman
   *  Segmentation). */
  void grow();

  /** Rays between two touching lines go to the line that explains them: the corner is put where the
   *  sum of both chi2 is smallest. */
  void contestCorners();

  /** Touching lines become one where a common line raises chi2 by less than chance allows. */
  void mergeCollinear();

  const std::vector<LineRun>& runs() const { return runs_; }

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
  bool continues(const Filter& filter, int position) const;
  bool seedAt(int position, LineSums& sums) const;

  void contest(int left, int right);
  void settleEnds(LineRun& left, LineRun& right, int leftIndex, int rightIndex, int begin, int end);
  bool collinear(const LineRun& left, const LineRun& right) const;
  void reassign(int firstPosition, int lastPosition, int from, int to);

  std::size_t at(int position) const { return static_cast<std::size_t>(ray(position)); }
  bool valid(int position) const { return scan_.valid[at(position)] != 0; }
  int& mark(int position) { return scan_.segmentOfRay[at(position)]; }
  double cosine(int position) const { return scan_.grid.cosines()[at(position)]; }
  double sine(int position) const { return scan_.grid.sines()[at(position)]; }
  double range_m(int position) const { return scan_.range_m[at(position)]; }
  void add(LineSums& sums, int p) const { sums.add(cosine(p), sine(p), range_m(p)); }
  void remove(LineSums& sums, int p) const { sums.remove(cosine(p), sine(p), range_m(p)); }
  double chi2(const LineSums& sums) const;

  const SegmentationOptions& options_;
  SegmentedScan& scan_;
  std::vector<LineRun>& runs_;
  int rays_;
  int start_;
  double variance_m2_;
};
}  // namespace psmks
