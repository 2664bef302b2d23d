/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/features/ShortLines.h>
#include <psmks/segmentation/LineInformation.h>

#include <cmath>

namespace psmks
{
namespace
{
/** Fewest rays of a short line. Unit: rays. Definition: two fix a line, the third tests it;
 * mayBegin() looks at three. */
constexpr int kFewestRays = 3;

/** Shortest line; what is shorter may be round. Evidence: measured. */
constexpr double kShortest_m = 0.25;

/** Standard deviations within which a ray continues a line. Unit: standard deviations. Evidence:
 * measured. */
constexpr double kGate = 3;

/** Smallest cosine of incidence of the first and the last ray. Unit: cosine. Evidence: measured. */
constexpr double kSteepest = 0.2;

/** Finds the short lines of a scan, one after the other. */
class ShortLineFinder
{
 public:
  ShortLineFinder(const SegmentedScan& scan, const std::vector<int>& circleOfRay,
                  std::vector<Segment>& lines)
      : scan_(scan), circleOfRay_(circleOfRay), lines_(lines)
  {
  }

  void run()
  {
    for (int first = 0; first + kFewestRays <= scan_.rays();)
      if (const Segment* segment = scan_.segmentAt(first))
        first = scan_.rayAfter(*segment, first);
      else
        first = mayBegin(first) ? lineFrom(first) + 1 : first + 1;
  }

 private:
  /** Whether a ray is valid and neither on a segment nor on a circle. */
  bool isSingle(int ray) const
  {
    return scan_.isValid(ray) && !scan_.segmentAt(ray) &&
           circleOfRay_[static_cast<std::size_t>(ray)] < 0;
  }

  /** Whether the first three rays of a line from here lie on one line, by the equation in
   * CollinearityStatistic.h. It rejects most rays at little cost. */
  bool mayBegin(int first) const
  {
    for (int ray = first; ray < first + kFewestRays; ++ray)
      if (!isSingle(ray)) return false;
    const MeasuredRay a = measured(first), b = measured(first + 1), c = measured(first + 2);
    const double twoCosine = 2 * (a.cosine * b.cosine + a.sine * b.sine);
    const auto power4 = [](double x) { return (x * x) * (x * x); };
    const double sum = a.inverseRange_1_m - twoCosine * b.inverseRange_1_m + c.inverseRange_1_m;
    const double variance = power4(a.inverseRange_1_m) +
                            twoCosine * twoCosine * power4(b.inverseRange_1_m) +
                            power4(c.inverseRange_1_m);
    return sum * sum <= kGate * kGate * scan_.rangeVarianceOf_m2(first) * variance;
  }

  MeasuredRay measured(int ray) const
  {
    const auto i = static_cast<std::size_t>(ray);
    return {scan_.grid.cosines()[i], scan_.grid.sines()[i], scan_.range_m[i], 1 / scan_.range_m[i]};
  }

  /** Grows a line from a ray, and keeps it if it is one.
   *  @return the last ray of the line; `first` where there is none */
  int lineFrom(int first)
  {
    const double variance_m2 = scan_.rangeVarianceOf_m2(first);
    LineInformation sums;
    LineInformation::Solution line{};
    int last = first - 1;
    for (int ray = first; ray < scan_.rays() && isSingle(ray); ++ray)
    {
      LineInformation more = sums;
      more.add(measured(ray));
      LineInformation::Solution longer{};
      if (more.rays() >= kFewestRays)
      {
        if (!more.solve(longer)) break;
        if (longer.chi2 - line.chi2 > kGate * kGate * variance_m2) break;
      }
      sums = more;
      line = longer;
      last = ray;
    }
    if (sums.rays() < kFewestRays) return first;
    return keep(line, variance_m2, sums.rays(), first, last) ? last : first;
  }

  /** Adds a line to the result if it is long enough and not grazed.
   *  @return whether it was added */
  bool keep(const LineInformation::Solution& solution, double variance_m2, int rays, int first,
            int last)
  {
    Segment segment;
    segment.line = solution.line(scan_.raysPerReading * variance_m2);
    segment.firstRay = first;
    segment.lastRay = last;
    segment.rays = rays;
    segment.sigma_m = std::sqrt(solution.chi2 / (rays - 2));
    segment.firstEnd_m = endAt(segment.line, first);
    segment.lastEnd_m = endAt(segment.line, last);
    const Eigen::Vector2d normal = segment.line.normal();
    const bool isSeen = normal.dot(scan_.grid.direction(first)) > kSteepest &&
                        normal.dot(scan_.grid.direction(last)) > kSteepest;
    if (!isSeen || segment.length_m() < kShortest_m) return false;
    lines_.push_back(segment);
    return true;
  }

  /** The point of a line at the bearing of a ray. */
  Eigen::Vector2d endAt(const Line& line, int ray) const
  {
    return line.rangeAt_m(scan_.grid.bearing_rad(ray)) * scan_.grid.direction(ray);
  }

  const SegmentedScan& scan_;
  const std::vector<int>& circleOfRay_;
  std::vector<Segment>& lines_;
};
}  // namespace

void findShortLines(const SegmentedScan& scan, const std::vector<int>& circleOfRay,
                    std::vector<Segment>& lines)
{
  lines.clear();
  ShortLineFinder(scan, circleOfRay, lines).run();
}
}  // namespace psmks
