/* psmks: polar scan matching based on Kalman segmentation. BSD-3-Clause, see LICENSE. */
#include <psmks/core/LineFilters.h>
#include <psmks/core/LineFit.h>
#include <psmks/core/Preprocessing.h>
#include <psmks/core/Segmentation.h>
#include <psmks/core/ThreeRayTest.h>

#include <algorithm>
#include <cmath>

namespace psmks
{
namespace
{
/** The sigma that is used: the scan's or the option's, raised to what the scan itself shows where
 * that is clearly more. */
double settledSigma_m(const Scan& scan, const SegmentationOptions& options,
                      const SegmentedScan& cleaned, std::vector<double>& scratch)
{
  constexpr double kClearlyMore = 1.6;
  constexpr double kLargest_m = 0.08;  // beyond, it is clutter and not noise
  const double stated_m = scan.rangeSigma_m > 0 ? scan.rangeSigma_m : options.rangeSigma_m;
  if (!options.estimateRangeSigma) return stated_m;
  const double shown_m = estimateRangeSigma_m(cleaned, scratch);
  return shown_m > kClearlyMore * stated_m ? std::min(shown_m, std::max(stated_m, kLargest_m))
                                           : stated_m;
}

/** The line of a run's rays by the filter that the options choose. */
LineFit fitRun(const SegmentedScan& scan, const RayRange& rays, const LineSums& sums,
               const SegmentationOptions& options)
{
  LineSums::Solution s{};
  if (!sums.solve(s)) return {};
  LineFit fit = fitLine(scan, rays, s.line(), scan.rangeSigma_m);
  if (options.filter == LineFilter::Linear) return fit;

  PolarLineFilter filter(scan.rangeSigma_m);
  LineSums seed;
  bool started = false;
  for (int k = 0, ray = rays.first; k < rays.count; ++k, ray = (ray + 1) % scan.rays())
  {
    const auto i = static_cast<std::size_t>(ray);
    if (scan.segmentOfRay[i] != rays.mark) continue;
    const double cosine = scan.grid.cosines()[i], sine = scan.grid.sines()[i];
    if (started)
    {
      filter.update(cosine, sine, scan.range_m[i]);
      continue;
    }
    seed.add(cosine, sine, scan.range_m[i]);
    started = seed.rays() >= options.seedRays && filter.start(seed);
  }
  if (started) fit.line = filter.line();
  return fit;
}

/** A bulge that is both significant and larger than the noise: long real walls are never quite
 *  straight, and a sagitta within the noise does no harm. */
bool isCurved(const LineFit& fit, double length_m, double sigma_m, double gate)
{
  const double sagitta_m = std::abs(fit.curvature_1_m) * length_m * length_m / 4;
  return std::abs(fit.curvature_1_m) > gate * fit.curvatureSigma_1_m && sagitta_m > sigma_m;
}

/** Variance of the distance of the line at its best known point. */
double offsetVariance_m2(const Line& line)
{
  const auto& P = line.covariance;
  return P(1, 1) > 0 ? P(0, 0) - P(0, 1) * P(0, 1) / P(1, 1) : P(0, 0);
}

bool isSegment(const LineFit& fit, const Segment& segment, const SegmentedScan& scan,
               const SegmentationOptions& options)
{
  if (fit.rays < options.minRays) return false;
  const Line& line = segment.line;
  if (!line.covariance.allFinite() || !(line.r0_m > 5 * scan.rangeSigma_m)) return false;
  if (fit.chi2 > options.maxReducedChi2 * (fit.rays - 2)) return false;
  if (offsetVariance_m2(line) > options.maxOffsetSigma_m * options.maxOffsetSigma_m) return false;
  if (line.covariance(1, 1) > options.maxAngleSigma_rad * options.maxAngleSigma_rad) return false;
  const Eigen::Vector2d n = line.normal();
  const double firstCosine = n.dot(scan.grid.direction(segment.firstRay));
  const double lastCosine = n.dot(scan.grid.direction(segment.lastRay));
  if (std::min(firstCosine, lastCosine) < options.minIncidenceCosine) return false;
  return !isCurved(fit, segment.length_m(), scan.rangeSigma_m, options.curvatureGate);
}

/** Widens a covariance where the residuals are significantly larger than the noise. */
double covarianceScale(const LineFit& fit)
{
  constexpr double kSignificance = 3;
  const double dof = std::max(1, fit.rays - 2);
  const double reduced = fit.chi2 / dof;
  return reduced > 1 + kSignificance * std::sqrt(2 / dof) ? reduced : 1;
}

Segment makeSegment(const LineFit& fit, int firstRay, int lastRay, const SegmentedScan& scan)
{
  Segment segment;
  segment.line = fit.line;
  segment.line.covariance *= covarianceScale(fit);
  segment.firstRay = firstRay;
  segment.lastRay = lastRay;
  segment.rays = fit.rays;
  segment.sigma_m = scan.rangeSigma_m * std::sqrt(fit.chi2 / std::max(1, fit.rays - 2));
  const auto endAt = [&](int ray) -> Eigen::Vector2d
  { return segment.line.rangeAt_m(scan.grid.bearing_rad(ray)) * scan.grid.direction(ray); };
  segment.firstEnd_m = endAt(firstRay);
  segment.lastEnd_m = endAt(lastRay);
  return segment;
}

/** Marks go from runs to segments; rays of dropped runs become single points. */
void finish(const LineRuns& lines, const SegmentationOptions& options, SegmentedScan& scan)
{
  int index = 0;
  for (const LineRun& run : lines.runs())
  {
    const RayRange rays{lines.ray(run.first), run.last - run.first + 1, index++};
    const LineFit fit = fitRun(scan, rays, run.sums, options);
    const Segment segment = makeSegment(fit, rays.first, lines.ray(run.last), scan);
    const bool kept = isSegment(fit, segment, scan, options);
    const int mark = kept ? static_cast<int>(scan.segments.size()) : SegmentedScan::kNoSegment;
    for (int p = run.first; p <= run.last; ++p)
    {
      int& m = scan.segmentOfRay[static_cast<std::size_t>(lines.ray(p))];
      if (m == rays.mark) m = mark;
    }
    if (kept) scan.segments.push_back(segment);
  }
}
}  // namespace

void segmentScan(const Scan& scan, const PreprocessingOptions& preprocessing,
                 const SegmentationOptions& options, SegmentationBuffers& buffers,
                 SegmentedScan& result)
{
  cleanScan(scan, preprocessing, result);
  medianFilter(preprocessing.medianWindow, buffers.scratch, result);
  result.rangeSigma_m = settledSigma_m(scan, options, result, buffers.scratch);

  LineRuns lines(options, result, buffers.runs);
  lines.grow();
  lines.contestCorners();
  lines.mergeCollinear();
  finish(lines, options, result);
}
}  // namespace psmks
