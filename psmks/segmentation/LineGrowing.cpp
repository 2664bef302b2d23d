/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/segmentation/LineFilters.h>
#include <psmks/segmentation/LineGrowing.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace psmks
{
namespace
{
/** Longest run of invalid rays across which a line is continued. Unit: rays. Evidence: measured. */
constexpr int kLongestHole = 3;

/** Most rays between two lines that still touch, so that a corner is sought between them. Unit:
 * rays. Evidence: measured. */
constexpr int kLongestGap = 3;

/** A second outlier within so many accepted rays after the first ends a line before the first.
 * Unit: rays. Evidence: measured. */
constexpr int kOutlierMemory = 2;

/** A corner is sought until the sum of both chi2 has not fallen for so many rays. Unit: rays.
 * Evidence: measured. */
constexpr int kPatience = 3;

/** What a line may gain in chi2 by the best of n cuts, as a factor of ln(n). Unit: chi2.
 * Definition: the largest of n samples of chi2 with 2 degrees of freedom grows as 2 ln(n). */
constexpr double kChi2OfBestCut = 2;
}  // namespace

LineGrowing::LineGrowing(const SegmentationOptions& options, RaySoA& rays,
                         std::vector<LineRun>& runs)
    : options_(options),
      rays_(rays),
      runs_(runs),
      variance_m2_(rays.noise.sigma_m * rays.noise.sigma_m)
{
  runs_.clear();
}

// ---- grow() ------------------------------------------------------------------------------------

void LineGrowing::grow()
{
  if (options_.filter == LineFilter::Linear)
    growAll(LinearLineFilter(rays_.noise));
  else
    growAll(PolarLineFilter(rays_.noise));
}

template <class Filter>
void LineGrowing::growAll(const Filter& fresh)
{
  int free = 0;  // first position after the last line
  for (int p = 0; p + options_.seedRays <= rays_.rays; ++p)
  {
    LineInformation seed;
    Filter filter = fresh;
    if (!seedAt(p, seed) || !filter.start(seed)) continue;
    const int index = static_cast<int>(runs_.size());
    LineRun run{p, p + options_.seedRays - 1, seed};
    reassign(run.first, run.last, SegmentedScan::kNoSegment, index);
    run.last = growSide(filter, run, index, run.last, 1, rays_.rays - 1);
    run.first = growSide(filter, run, index, run.first, -1, free);
    dropOutlyingStart(filter, run);
    runs_.push_back(run);
    free = run.last + 1;
    p = run.last;
  }
}

/** Takes the first ray out of a grown line if the line does not accept it. The seed, a line of few
 * rays, bends towards an outlier among them; the grown line does not. */
template <class Filter>
void LineGrowing::dropOutlyingStart(const Filter& grown, LineRun& run)
{
  if (run.sums.rays() <= options_.seedRays) return;
  if (grown.accepts(rays_.measured(run.first), options_.innovationGate)) return;
  mark(run.first) = SegmentedScan::kNoSegment;
  run.sums.removeMoments(moments(run.first));
  do ++run.first;
  while (mark(run.first) == SegmentedScan::kNoSegment);
}

/** Computes the sums of the seed at a position.
 *  @return whether all of its rays are valid and lie on one line */
bool LineGrowing::seedAt(int position, LineInformation& sums) const
{
  for (int p = position; p < position + options_.seedRays; ++p)
  {
    if (!rays_.valid(p)) return false;
    sums.addMoments(moments(p));
  }
  // This approximates the 0.998 quantile of chi2 for one to four degrees of freedom.
  const double gate = options_.innovationGate;
  return chi2(sums) < gate * gate + options_.seedRays - 3;
}

/** Grows a line to one side, ray by ray or in blocks. An isolated outlier is skipped; a second
 * outlier soon after it ends the line before the first.
 *  @param index of the run, which its rays are marked with
 *  @param from position of the line's outermost ray on this side
 *  @param step +1 or -1
 *  @param limit last position that the line may reach
 *  @return the outermost position of the line on this side */
template <class Filter>
int LineGrowing::growSide(Filter& filter, LineRun& run, int index, int from, int step, int limit)
{
  int last = from, hole = 0, sinceOutlier = kOutlierMemory;
  BeforeOutlier<Filter> before{from, run.sums, filter};
  int sinceRefusal = RaySoA::kBlock;  // rays that were tested singly since a block was refused
  for (int p = from + step; p != limit + step && hole <= kLongestHole; p += step)
  {
    if (sinceRefusal >= RaySoA::kBlock)
    {
      if (takeBlock(filter, run, index, p, step, limit))
      {
        last = p += step * (RaySoA::kBlock - 1);
        sinceOutlier += RaySoA::kBlock;
        hole = 0;
        continue;
      }
      sinceRefusal = 0;
    }
    ++sinceRefusal;
    hole = rays_.valid(p) ? 0 : hole + 1;
    if (hole > 0) continue;
    if (takeRay(filter, run, index, p))
    {
      last = p;
      ++sinceOutlier;
      continue;
    }
    if (sinceOutlier < kOutlierMemory)
    {
      giveBack(before, p, step, index, filter, run);
      return before.last;
    }
    before = {last, run.sums, filter};
    sinceOutlier = 0;
  }
  return last;
}

/** Grows a line by one ray if the filter accepts it.
 *  @return whether the ray was taken */
template <class Filter>
bool LineGrowing::takeRay(Filter& filter, LineRun& run, int index, int position)
{
  const MeasuredRay ray = rays_.measured(position);
  if (!filter.accepts(ray, options_.innovationGate)) return false;
  run.sums.addMoments(moments(position));
  filter.update(ray, run.sums);
  mark(position) = index;
  return true;
}

/** Makes a line what it was before its last outlier: the rays since then, up to a position, become
 * free again. */
template <class Filter>
void LineGrowing::giveBack(const BeforeOutlier<Filter>& before, int position, int step, int index,
                           Filter& filter, LineRun& run)
{
  const int first = before.last + step;
  reassign(std::min(first, position), std::max(first, position), index, SegmentedScan::kNoSegment);
  run.sums = before.sums;
  filter = before.filter;
}

/** Grows a line by the next block of rays if the linear filter accepts all of them.
 *  @param from position of the first ray of the block, in the direction of `step`
 *  @return whether the block was taken */
template <class Filter>
bool LineGrowing::takeBlock(Filter& filter, LineRun& run, int index, int from, int step, int limit)
{
  if constexpr (std::is_same_v<Filter, LinearLineFilter>)
  {
    /** Rays of a block besides the first. Unit: rays. Definition: one less than a block. */
    constexpr int kOthers = RaySoA::kBlock - 1;

    if (!filter.takesBlocks(run.sums) || (limit - from) * step < kOthers) return false;
    const int first = std::min(from, from + step * kOthers);
    if (!filter.acceptsBlock(rays_, first, options_.innovationGate)) return false;
    run.sums.addMoments(&moments(first), RaySoA::kBlock);
    filter.update(run.sums);
    std::fill_n(&mark(first), RaySoA::kBlock, index);
    return true;
  }
  return false;
}

/** Marks with `to` those rays between two positions (both included) that carry the mark `from`. */
void LineGrowing::reassign(int firstPosition, int lastPosition, int from, int to)
{
  for (int p = firstPosition; p <= lastPosition; ++p)
    if (mark(p) == from) mark(p) = to;
}

// ---- contestCorners() and mergeCollinear() ------------------------------------------------------

void LineGrowing::contestCorners()
{
  for (std::size_t right = 1; right < runs_.size(); ++right)
    if (runs_[right].first - runs_[right - 1].last <= kLongestGap + 1)
      contest(static_cast<int>(right) - 1, static_cast<int>(right));
}

/** Moves the corner between two runs to its best place. The rays of both lines within reach of the
 * corner are contested; each line keeps the rays of a seed beyond them.
 *
 *   left  o o o o o|. . . . . .|          rays before the split go to the left line, the others to
 *                  |. . . . . .|o o o o   the right line
 *
 * The search begins at the corner that growth has left and goes to both sides, until chi2 has not
 * fallen for kPatience rays. */
void LineGrowing::contest(int leftIndex, int rightIndex)
{
  LineRun& left = runs_[static_cast<std::size_t>(leftIndex)];
  LineRun& right = runs_[static_cast<std::size_t>(rightIndex)];
  const int reach = options_.cornerReach, kept = options_.seedRays;
  const int begin = std::max(left.last + 1 - reach, std::min(left.first + kept, left.last + 1));
  const int end = std::min(right.first + reach, std::max(right.last + 1 - kept, right.first));

  Split best{right.first, left.sums, right.sums, left.sums.chi2_m2() + right.sums.chi2_m2()};
  const Split grown = best;
  moveSplit(grown, 1, end, rightIndex, best);
  moveSplit(grown, -1, begin, leftIndex, best);
  if (best.at == grown.at) return;
  for (int p = begin; p < end; ++p)
    if (mark(p) == leftIndex || mark(p) == rightIndex)
      mark(p) = p < best.at ? leftIndex : rightIndex;
  left.sums = best.left;
  right.sums = best.right;
  settleEnds(left, right, leftIndex, rightIndex, begin, end);
}

/** Moves a split ray by ray and keeps the one with the smallest chi2.
 *  @param step +1 gives rays of the right line to the left one, up to `limit` (excluded); -1 gives
 * rays of the left line to the right one, down to `limit` (included)
 *  @param from the mark of the rays that are given away
 *  @param[in,out] best the best split so far */
void LineGrowing::moveSplit(Split split, int step, int limit, int from, Split& best) const
{
  LineInformation& giving = step > 0 ? split.right : split.left;
  LineInformation& taking = step > 0 ? split.left : split.right;
  for (int sinceBest = 0; split.at != limit && sinceBest < kPatience;)
  {
    const int p = step > 0 ? split.at : split.at - 1;
    split.at += step;
    if (mark(p) != from) continue;
    giving.removeMoments(moments(p));
    taking.addMoments(moments(p));
    if (giving.rays() < 2) return;
    split.chi2_m2 = split.left.chi2_m2() + split.right.chi2_m2();
    ++sinceBest;
    if (split.chi2_m2 >= best.chi2_m2) continue;
    best = split;
    sinceBest = 0;
  }
}

/** Sets the ends of two contested runs to their outermost rays.
 *  @param begin, end the contested positions, `end` excluded */
void LineGrowing::settleEnds(LineRun& left, LineRun& right, int leftIndex, int rightIndex,
                             int begin, int end)
{
  left.last = std::max(left.first, begin - 1);
  right.first = std::min(right.last, end);
  for (int p = begin; p < end; ++p)
    if (mark(p) == leftIndex) left.last = p;
  for (int p = end - 1; p >= begin; --p)
    if (mark(p) == rightIndex) right.first = p;
}

/** Whether two runs touch and are one line. */
bool LineGrowing::collinear(const LineRun& left, const LineRun& right) const
{
  if (right.first - left.last > kLongestGap + 1) return false;
  LineInformation joint = left.sums;
  joint += right.sums;
  return chi2(joint) - chi2(left.sums) - chi2(right.sums) < options_.mergeChi2;
}

bool LineGrowing::cut(const LineRun& run, int runMark, LineRun& left, LineRun& right) const
{
  LineInformation l, r = run.sums;
  double best =
      chi2(run.sums) - options_.mergeChi2 - kChi2OfBestCut * std::log(std::max(1, run.sums.rays()));
  bool found = false;
  for (int p = run.first; p < run.last && r.rays() > options_.seedRays; ++p)
  {
    if (mark(p) != runMark) continue;
    l.addMoments(moments(p));
    r.removeMoments(moments(p));
    if (l.rays() < options_.seedRays) continue;
    const double sum = chi2(l) + chi2(r);
    if (sum >= best) continue;
    best = sum;
    found = true;
    left = {run.first, p, l};
    right = {p + 1, run.last, r};
  }
  return found;
}

void LineGrowing::mergeCollinear()
{
  std::size_t kept = 0;
  for (std::size_t next = 1; next < runs_.size(); ++next)
  {
    LineRun& left = runs_[kept];
    const LineRun& right = runs_[next];
    const int from = static_cast<int>(next);
    const int to = static_cast<int>(collinear(left, right) ? kept : kept + 1);
    if (to != from) reassign(right.first, right.last, from, to);
    if (static_cast<std::size_t>(to) == kept)
    {
      left.sums += right.sums;
      left.last = right.last;
    }
    else
      runs_[++kept] = right;
  }
  if (!runs_.empty()) runs_.resize(kept + 1);
}
}  // namespace psmks
