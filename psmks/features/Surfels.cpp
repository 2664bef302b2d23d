/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/features/Surfels.h>
#include <psmks/segmentation/LineInformation.h>

#include <cmath>

namespace psmks
{
namespace
{
/** Longest surfel. Evidence: measured. */
constexpr double kLongest_m = 0.25;

/** Largest distance of neighbouring points on one object. Evidence: measured. */
constexpr double kLargestStep_m = 0.12;

/** Fewest rays of a surfel. Unit: rays. Definition: two fix a line, the third tells its noise. */
constexpr int kFewestRays = 3;

/** Standard deviation by which the true surface is off the line of a surfel. Evidence: measured. */
constexpr double kShape_m = 0.01;

/** Smallest cosine of incidence of the middle ray. Unit: cosine. Evidence: measured. */
constexpr double kSteepest = 0.3;

/** Largest standard deviation of the rays from the line of a surfel. Evidence: measured. */
constexpr double kRoughest_m = 0.03;

/** Finds the surfels of a scan. */
class SurfelFinder
{
 public:
  SurfelFinder(const SegmentedScan& scan, std::vector<AnchoredLine>& lines,
               std::vector<int>& lineOfRay)
      : scan_(scan), lines_(lines), lineOfRay_(lineOfRay)
  {
  }

  void run()
  {
    for (int first = 0; first < scan_.rays();)
      if (const Segment* segment = scan_.segmentAt(first))
        first = scan_.rayAfter(*segment, first);
      else
        first = surfelFrom(first) + 1;
  }

 private:
  /** Whether a ray is valid and on no line. */
  bool single(int ray) const
  {
    return scan_.isValid(ray) && lineOfRay_[static_cast<std::size_t>(ray)] < 0;
  }

  /** Fits a surfel to the rays from one on that are near enough to each other.
   *  @return the last of these rays */
  int surfelFrom(int first)
  {
    if (!single(first)) return first;
    LineInformation sums;
    const Eigen::Vector2d start_m = scan_.point_m(first);
    Eigen::Vector2d previous_m = start_m;
    int last = first;
    for (int ray = first; ray < scan_.rays() && single(ray); ++ray)
    {
      const Eigen::Vector2d point_m = scan_.point_m(ray);
      if ((point_m - previous_m).norm() > kLargestStep_m) break;
      if ((point_m - start_m).norm() > kLongest_m) break;
      const auto i = static_cast<std::size_t>(ray);
      sums.add(
          {scan_.grid.cosines()[i], scan_.grid.sines()[i], scan_.range_m[i], 1 / scan_.range_m[i]});
      previous_m = point_m;
      last = ray;
    }
    if (sums.rays() >= kFewestRays) keep(sums, first, last);
    return last;
  }

  /** Adds a surfel to the result if it is neither rough nor grazed. */
  void keep(const LineInformation& sums, int first, int last)
  {
    LineInformation::Solution s{};
    if (!sums.solve(s)) return;
    const double variance_m2 =
        std::max(scan_.rangeVarianceOf_m2(first), s.chi2 / std::max(1, sums.rays() - 2));
    if (variance_m2 > kRoughest_m * kRoughest_m) return;
    AnchoredLine surfel(s.line(variance_m2));
    const double cosine = surfel.normal.dot(scan_.point_m((first + last) / 2).normalized());
    if (cosine < kSteepest) return;
    surfel.distanceVariance_m2 += kShape_m * kShape_m;
    const int index = static_cast<int>(lines_.size());
    lines_.push_back(surfel);
    for (int ray = first; ray <= last; ++ray) lineOfRay_[static_cast<std::size_t>(ray)] = index;
  }

  const SegmentedScan& scan_;
  std::vector<AnchoredLine>& lines_;
  std::vector<int>& lineOfRay_;
};
}  // namespace

void appendSurfels(const SegmentedScan& scan, std::vector<AnchoredLine>& lines,
                   std::vector<int>& lineOfRay)
{
  SurfelFinder(scan, lines, lineOfRay).run();
}
}  // namespace psmks
