/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/segmentation/RaySoA.h>
#include <psmks/segmentation/SegmentationOptions.h>

#include <vector>

namespace psmks
{
/** A line that is being grown: the stretch of rays that it covers, most of which belong to it. */
struct LineRun
{
  int first = 0, last = 0;  //!< positions of its outermost rays, as in RaySoA
  LineInformation sums;     //!< of the rays that belong to it
};

/** Finds the lines of a scan in three steps: grow(), contestCorners(), mergeCollinear().
 *
 * Rays are addressed by their positions in RaySoA. A ray that belongs to run k carries the mark k.
 * Runs stand in the order of their positions and do not overlap. */
class LineGrowing
{
 public:
  /** All arguments are kept by reference.
   *  @param rays the columns of a cleaned scan, with their moments and without marks; the steps
   * mark them
   *  @param runs storage for the runs; what it held is replaced */
  LineGrowing(const SegmentationOptions& options, RaySoA& rays, std::vector<LineRun>& runs);

  /** Grows lines from seeds of consecutive rays by the Kalman filter that the options choose
   * (paper, section 2: Kalman Segmentation). */
  void grow();

  /** Moves the corner between each two touching lines to where the sum of both chi2 is smallest:
   * the maximum-likelihood corner (docs/how-it-works.md). */
  void contestCorners();

  /** Merges touching lines whose common line raises chi2 by less than
   * SegmentationOptions::mergeChi2.
   */
  void mergeCollinear();

  /** The lines found so far. */
  const std::vector<LineRun>& runs() const { return runs_; }

  /** Cuts a run in two if that lowers chi2 by more than the best of all cuts does by chance. Two
   * walls a few millimetres apart pass for one line ray by ray.
   *  @param mark of the run's rays; the rays of both parts keep it
   *  @param[out] left, right the parts; unchanged where the run is not cut
   *  @return whether the run was cut */
  bool cut(const LineRun& run, int mark, LineRun& left, LineRun& right) const;

 private:
  /** A line as it was before its last outlier. Growth returns to it where a second outlier follows.
   */
  template <class Filter>
  struct BeforeOutlier
  {
    int last;  //!< position of its outermost ray
    LineInformation sums;
    Filter filter;
  };

  template <class Filter>
  void growAll(const Filter& fresh);
  template <class Filter>
  int growSide(Filter& filter, LineRun& run, int index, int from, int step, int limit);
  template <class Filter>
  bool takeRay(Filter& filter, LineRun& run, int index, int position);
  template <class Filter>
  void giveBack(const BeforeOutlier<Filter>& before, int position, int step, int index,
                Filter& filter, LineRun& run);
  template <class Filter>
  bool takeBlock(Filter& filter, LineRun& run, int index, int from, int step, int limit);
  template <class Filter>
  void dropOutlyingStart(const Filter& grown, LineRun& run);
  bool seedAt(int position, LineInformation& sums) const;

  /** A place of the corner between two lines, with the sums of both. */
  struct Split
  {
    int at = 0;  //!< first position of the right line
    LineInformation left, right;
    double chi2_m2 = 0;  //!< sum over both lines
  };

  void contest(int left, int right);
  void moveSplit(Split split, int step, int limit, int from, Split& best) const;
  void settleEnds(LineRun& left, LineRun& right, int leftIndex, int rightIndex, int begin, int end);
  bool collinear(const LineRun& left, const LineRun& right) const;
  void reassign(int firstPosition, int lastPosition, int from, int to);

  int& mark(int position) { return rays_.mark[static_cast<std::size_t>(position)]; }
  int mark(int position) const { return rays_.mark[static_cast<std::size_t>(position)]; }
  const LineInformation::Moments& moments(int position) const
  {
    return rays_.moments[static_cast<std::size_t>(position)];
  }
  double chi2(const LineInformation& sums) const { return sums.chi2_m2() / variance_m2_; }

  const SegmentationOptions& options_;
  RaySoA& rays_;
  std::vector<LineRun>& runs_;
  double variance_m2_;
};
}  // namespace psmks
