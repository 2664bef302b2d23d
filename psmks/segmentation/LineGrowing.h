/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#pragma once

#include <psmks/segmentation/RaySoA.h>
#include <psmks/segmentation/SegmentationOptions.h>

#include <vector>

namespace psmks
{
/** A line in the making: a run of rays, most of which belong to it. */
struct LineRun
{
  int first = 0, last = 0;  //!< positions, see LineGrowing
  LineInformation sums;     //!< of the rays that belong to it
};

/** The lines of a scan while they are made: grown, contested and merged.
 *
 * Rays are counted by position, see RaySoA. A ray that belongs to run k carries the mark k;
 * runs stand in the order of their positions and do not overlap. */
class LineGrowing
{
 public:
  /** @param rays of a cleaned scan, with their moments and no mark; marked here
   *  @param runs storage; what it held is replaced */
  LineGrowing(const SegmentationOptions& options, RaySoA& rays, std::vector<LineRun>& runs);

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

 private:
  /** The state of a growing line before the last outlier that it passed over. */
  template <class Filter>
  struct BeforeOutlier
  {
    int last;  //!< position of its last ray
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
  int restore(const BeforeOutlier<Filter>& before, Filter& filter, LineRun& run, int index,
              int reached, int step);
  template <class Filter>
  bool takeBlock(Filter& filter, LineRun& run, int index, int from, int step, int limit);
  template <class Filter>
  void dropOutlyingStart(const Filter& grown, LineRun& run);
  bool seedAt(int position, LineInformation& sums) const;

  /** Where one line ends and the next begins. */
  struct Split
  {
    int at;  //!< first position of the right line
    LineInformation left, right;
    double chi2_m2;  //!< of both
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
